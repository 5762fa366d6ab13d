// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The accounts of a device's memory.
#include "pbd/device/device.h"

#include <meniscus/error.h>
#include <algorithm>

namespace meniscus::pbd {

namespace {

void count(MemoryUse& use, size_t bytes) {
  use.bytes += bytes;
  use.peak_bytes = std::max(use.peak_bytes, use.bytes);
  ++use.allocations;
}

}  // namespace

void* Device::allocate(size_t bytes, const char* what) {
  size_t& held = held_[what];
  void* memory = do_allocate(bytes);
  if (!memory) refuse(bytes, what);
  held += bytes;
  count(memory_, bytes);
  return memory;
}

void* Device::allocate_shared(size_t bytes, const char* what) {
  void* memory = do_allocate_shared(bytes);
  if (!memory) refuse(bytes, what);
  count(shared_memory_, bytes);
  return memory;
}

void Device::release_shared(void* memory, size_t bytes) noexcept {
  if (!memory) return;
  do_release_shared(memory);
  shared_memory_.bytes -= bytes;
}

void Device::refuse(size_t bytes, const char* what) const {
  throw Error(ErrorCode::out_of_memory,
              "no memory for " + std::string(what) + ": " + std::to_string(bytes >> 20) + " MiB asked on " +
                  name() + ", which holds " + std::to_string(memory_.bytes >> 20) + " MiB for this world");
}

void Device::release(void* memory, size_t bytes, const char* what) noexcept {
  do_release(memory);
  memory_.bytes -= bytes;
  held_.find(what)->second -= bytes;
}

}  // namespace meniscus::pbd
