// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Installs and restores the handlers of SIGINT and SIGTERM.
#include "sdk/cli/stop/interrupt.h"

#include <atomic>

namespace meniscus::cli {
namespace {

// A signal handler can only reach global variables; these are the only ones of the program.
volatile std::sig_atomic_t flag = 0;
std::atomic<World*> stepped = nullptr;
static_assert(std::atomic<World*>::is_always_lock_free);

extern "C" void raise_flag(int) {
  flag = 1;
  if (World* world = stepped.load()) world->cancel();
}

}  // namespace

Interrupt::Interrupt(World& world) : Interrupt() {
  watch(&world);
}

Interrupt::Interrupt() {
  flag = 0;
  struct sigaction action {};
  action.sa_handler = raise_flag;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, &old_int_);
  sigaction(SIGTERM, &action, &old_term_);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &old_int_, nullptr);
  sigaction(SIGTERM, &old_term_, nullptr);
  stepped = nullptr;
}

void Interrupt::watch(World* world) {
  stepped = world;
}

bool Interrupt::raised() const {
  return flag != 0;
}

}  // namespace meniscus::cli
