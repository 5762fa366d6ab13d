// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Numbers that tell living worlds apart.
#include "sdk/world/check/world_number.h"

#include <meniscus/error.h>

#include <bitset>
#include <mutex>

namespace meniscus {

namespace {

constexpr uint32_t numbers = 1u << 16;

// What all worlds of a process share. Neither has a destructor that a static world could outlive.
std::mutex mutex;
std::bitset<numbers> taken;
uint32_t last = 0;

}  // namespace

// Numbers are given in turn, so that one that is free again rests for as long as possible.
WorldNumber::WorldNumber() : number_(0) {
  const std::lock_guard lock(mutex);
  for (uint32_t tries = 0; tries < numbers && number_ == 0; ++tries) {
    last = (last + 1) % numbers;
    if (last != 0 && !taken[last]) number_ = last;
  }
  if (number_ == 0)
    throw Error(ErrorCode::capacity, "a process has room for no more than 65535 worlds at once");
  taken[number_] = true;
}

WorldNumber::~WorldNumber() {
  const std::lock_guard lock(mutex);
  taken[number_] = false;
}

}  // namespace meniscus
