// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How many threads go through a list whose length a kernel has counted.
#pragma once

#include <algorithm>
#include <cstdint>

namespace meniscus::pbd {

/// The CPU has finished the kernel, so the length is known: `counted`, up to the list's `room`. A GPU may not
/// have begun it: there, as many threads as the list has room for, up to `most`. `counted` is read on the CPU
/// alone.
template <class D>
uint32_t launch_size(const uint32_t& counted, size_t room, size_t most) {
  if constexpr (D::runs_at_once) return static_cast<uint32_t>(std::min(room, most));
  return static_cast<uint32_t>(std::min(size_t{counted}, room));
}

}  // namespace meniscus::pbd
