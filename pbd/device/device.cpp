// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The accounts of a device's memory.
#include "pbd/device/device.h"

#include <meniscus/error.h>
#include <algorithm>

namespace meniscus::pbd {

void* Device::allocate(size_t bytes, const char* what) {
  size_t& held = held_[what];
  void* memory = do_allocate(bytes);
  if (!memory) refuse(bytes, what);
  held += bytes;
  memory_.bytes += bytes;
  memory_.peak_bytes = std::max(memory_.peak_bytes, memory_.bytes);
  ++memory_.allocations;
  return memory;
}

void* Device::allocate_shared(size_t bytes, const char* what) {
  void* memory = do_allocate_shared(bytes);
  if (!memory) refuse(bytes, what);
  ++memory_.allocations;
  return memory;
}

void Device::release_shared(void* memory) noexcept {
  if (memory) do_release_shared(memory);
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
