// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reorders an array by a permutation.
#pragma once

#include "pbd/particles.h"

namespace meniscus::pbd {

template <class T>
struct GatherInOrder {
  View<const T> from;
  View<const uint32_t> order;
  View<T> to;

  MENISCUS_HD void operator()(uint32_t i) const { to[i] = from[order[i]]; }
};

/// Element i becomes what was at order[i].
template <class D, class T>
void gather_in_order(D& device, const char* name, DoubleBuffer<T>& values, View<const uint32_t> order,
                     uint32_t count) {
  device.parallel_for(name, count, GatherInOrder<T>{values.current.view(), order, values.next.view()});
  values.flip();
}

}  // namespace meniscus::pbd
