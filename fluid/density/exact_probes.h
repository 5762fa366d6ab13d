// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What probes measure, summed up exactly: for fixed sums, and for worlds that ranks share. The sums have the
// same bits whatever the number of ranks.
#pragma once

#include <vector>

#include "pbd/device/base/view.h"
#include "pbd/ghosts.h"
#include "pbd/math/exact_sum.h"

namespace meniscus::fluid {

/// The sums of a probe.
struct ProbeSum {
  double value, weight;  ///< a scalar; what `value`, x, y and z are weighted with, or 0
  double x, y, z;        ///< a vector
};

namespace probe_kernels {

/// A ProbeSum without rounding.
struct ExactProbeSum {
  static constexpr int count = 5;
  pbd::ExactSum sums[count];

  MENISCUS_HD ExactProbeSum operator+(const ExactProbeSum& other) const {
    ExactProbeSum all;
    for (int k = 0; k < count; ++k) all.sums[k] = sums[k] + other.sums[k];
    return all;
  }
};

/// The values of another map, as exact sums.
template <class Map>
struct Exactly {
  Map map;

  MENISCUS_HD ExactProbeSum operator()(uint32_t i) const {
    const ProbeSum s = map(i);
    using pbd::ExactSum;
    return {ExactSum::of(s.value), ExactSum::of(s.weight), ExactSum::of(s.x), ExactSum::of(s.y),
            ExactSum::of(s.z)};
  }
};

struct AddExactly {
  MENISCUS_HD ExactProbeSum operator()(const ExactProbeSum& a, const ExactProbeSum& b) const { return a + b; }
};

struct AccumulateExactly {
  pbd::View<const ExactProbeSum> value;
  pbd::View<ExactProbeSum> totals;
  uint32_t probe;

  MENISCUS_HD void operator()(uint32_t) const { totals[probe] = totals[probe] + value[0]; }
};

}  // namespace probe_kernels

/// Replaces the sums of a rank by those of all.
inline void add_over_ranks(pbd::GhostExchange& ranks, std::vector<probe_kernels::ExactProbeSum>& sums) {
  using pbd::ExactSum;
  std::vector<uint64_t> parts;
  for (const probe_kernels::ExactProbeSum& of_probe : sums) {
    for (const ExactSum& sum : of_probe.sums) {
      const auto own = sum.split();
      parts.insert(parts.end(), own.begin(), own.end());
    }
  }
  ranks.add_up(parts);
  const uint64_t* next = parts.data();
  for (probe_kernels::ExactProbeSum& of_probe : sums) {
    for (ExactSum& sum : of_probe.sums) {
      sum = ExactSum::joined(next);
      next += ExactSum::parts;
    }
  }
}

}  // namespace meniscus::fluid
