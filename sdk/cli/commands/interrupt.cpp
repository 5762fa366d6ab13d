// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Installs and restores the handlers of SIGINT and SIGTERM.
#include "sdk/cli/commands/interrupt.h"

namespace meniscus::cli {
namespace {

// A signal handler can only reach a global variable; this is the only one of the program.
volatile std::sig_atomic_t flag = 0;

extern "C" void raise_flag(int) {
  flag = 1;
}

}  // namespace

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
}

bool Interrupt::raised() const {
  return flag != 0;
}

}  // namespace meniscus::cli
