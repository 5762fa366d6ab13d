// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The V-cycle and the conjugate gradients of the multigrid, as launches of kernels.
#pragma once

#include <algorithm>
#include <utility>

#include "fluid/pressure_grid/multigrid.h"
#include "fluid/pressure_grid/tuning.h"

namespace meniscus::fluid {

template <class D>
void Multigrid<D>::fit(const NodeTable& table) {
  using namespace multigrid_kernels;
  // The table is halved down to one node: the sum is at most twice the first.
  const size_t most = 2 * size_t{table.count()};
  if (coefficients_.size() < most) {
    coefficients_.resize_discard(0);
    pressure_.resize_discard(most);
    right_.resize_discard(most);
    solution_.resize_discard(table.count());
    direction_.resize_discard(table.count());
    image_.resize_discard(table.count());
    products_.resize_discard(3);
    coefficients_.resize_discard(most);  // last: its length is the one that is tested
  }
  levels_.clear();
  NodeTable present = table;
  for (uint32_t first = 0;;) {
    const uint32_t count = present.count();
    levels_.push_back({present, coefficients_.view().from(first).first(count),
                       pressure_.view().from(first).first(count), right_.view().from(first).first(count)});
    if (count == 1) break;
    first += count;
    for (uint32_t& bits : present.bits) bits -= bits > 0 ? 1 : 0;
    present.strip_bits = std::min(present.strip_bits, present.bits[1]);
  }
  first_small_ = 0;
  while (levels_[first_small_].table.count() > 1u << multigrid_tuning::small_bits) ++first_small_;
}

template <class D>
multigrid_kernels::SmallLevels Multigrid<D>::small() const {
  multigrid_kernels::SmallLevels small{};
  small.count = static_cast<uint32_t>(levels_.size() - first_small_);
  small.sweeps = multigrid_tuning::small_sweeps;
  std::copy(levels_.begin() + static_cast<std::ptrdiff_t>(first_small_), levels_.end(), small.level);
  return small;
}

template <class D>
void Multigrid<D>::solve(int iterations) {
  using namespace multigrid_kernels;
  Level& finest = levels_.front();
  const uint32_t nodes = finest.table.count();
  Search search{solution_.view(), direction_.view(), image_.view(), products_.view(), 0, 1};
  const auto product = [&](uint32_t place) { return View<double>{products_.view().data + place, 1}; };
  coarsen();
  for (int k = 0; k < iterations; ++k) {
    cycle(0);
    device_.reduce("multigrid/finish", nodes, 0.0, FinishCycle{finest}, Sum{}, product(search.now));
    if (k == 0)
      std::swap(finest.pressure, search.direction);  // the first result is the direction
    else
      device_.parallel_for("multigrid/turn", nodes, TurnDirection{finest, search});
    device_.reduce("multigrid/apply", nodes, 0.0, ApplyToDirection{finest, search}, Sum{},
                   product(Search::curvature));
    device_.parallel_for("multigrid/step", nodes, StepAlong{finest, search, k == 0});
    std::swap(search.now, search.before);
  }
}

template <class D>
void Multigrid<D>::coarsen() {
  using namespace multigrid_kernels;
  for (size_t k = 0; k < first_small_; ++k)
    device_.parallel_for("multigrid/coarsen", levels_[k + 1].table.count(),
                         Coarsen{levels_[k], levels_[k + 1]});
  device_.parallel_for_groups("multigrid/coarsen small", 1, CoarsenSmall{small()});
}

/// A V-cycle without the last half of the finest level's sweep: see FinishCycle.
template <class D>
void Multigrid<D>::cycle(size_t level) {
  using namespace multigrid_kernels;
  if (level == first_small_) return device_.parallel_for_groups("multigrid/small", 1, SolveSmall{small()});
  const Level& fine = levels_[level];
  const Level& coarse = levels_[level + 1];
  const uint32_t nodes = fine.table.count();
  device_.parallel_for("multigrid/start", nodes, StartSweep{fine});
  device_.parallel_for("multigrid/restrict", coarse.table.count(), Restrict{fine, coarse});
  cycle(level + 1);
  device_.parallel_for("multigrid/prolong", nodes, ProlongAndRelax{fine, coarse});
  if (level > 0) device_.parallel_for("multigrid/relax", nodes, Relax{fine, 0});
}

}  // namespace meniscus::fluid
