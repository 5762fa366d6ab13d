// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Groups for kernels of groups (CpuDevice::parallel_for_groups), whose threads have one lane.
#pragma once

#include <cstdint>

namespace meniscus::tests {

struct OneLane {
  using Real = float;
  static constexpr uint32_t lane_count = 1;
};

/// Several threads, one after the other.
struct ManyThreads {
  using Device = OneLane;
  static constexpr bool is_one_thread = false;
  template <class F>
  void for_each(uint32_t count, const F& f) const {
    for (uint32_t i = 0; i < count; ++i) f(i);
  }
  template <class F>
  bool any(uint32_t count, const F& f) const {
    bool found = false;
    for (uint32_t i = 0; i < count; ++i) found = f(i) || found;
    return found;
  }
};

struct OneThread : ManyThreads {
  static constexpr bool is_one_thread = true;
};

}  // namespace meniscus::tests
