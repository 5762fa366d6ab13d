// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Disjoint sets that threads unite concurrently.
#pragma once

#include <cstdint>

#include "pbd/device/base/atomics.h"
#include "pbd/device/base/view.h"

namespace meniscus::pbd {

/// Disjoint sets of numbers, each named by its greatest member. Labels lead from number to number upwards, to
/// the name. A find shortens the path for later ones (path halving, as in ECL-CC, Jaiganesh & Burtscher
/// 2018). Any number of threads may unite concurrently; the final names do not depend on the order.
struct UnionFind {
  View<uint32_t> label;

  MENISCUS_HD uint32_t name(uint32_t n) const {
    uint32_t next = atomic_load(label[n]);
    while (next != n) {
      const uint32_t beyond = atomic_load(label[next]);
      if (beyond != next) atomic_store(label[n], beyond);
      n = next;
      next = beyond;
    }
    return n;
  }

  MENISCUS_HD void unite(uint32_t a, uint32_t b) const {
    for (;;) {
      a = name(a);
      b = name(b);
      if (a == b) return;
      const uint32_t lower = a < b ? a : b, upper = a < b ? b : a;
      // Else another thread has changed the label meanwhile.
      if (atomic_exchange_if(label[lower], lower, upper) == lower) return;
    }
  }
};

}  // namespace meniscus::pbd
