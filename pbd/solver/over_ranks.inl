// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// One world over many ranks: what a solver does differently there. See pbd/rank_exchange.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "pbd/solver.h"
#include "pbd/solver_kernels.h"

namespace meniscus::pbd {

/// The room of a rank that needs this much: a sixteenth more, since particles come and go.
inline uint32_t room_for_own(uint32_t needed) {
  constexpr uint32_t least = 1024;
  return std::max(needed + needed / 16, least);
}

/// Sends particles to the ranks that own their predicted positions, or have them as ghosts. The particles
/// that this rank then needs count as sorted: its own, and behind them the ghosts.
template <class D>
CellOrder Solver<D>::order_among_ranks(const solver_kernels::Prediction& prediction) {
  Particles& p = particles_;
  search_.set_slab(exchange_->layers_along_y(), exchange_->first_layer(), exchange_->end_layer());
  const Aabb extent{summary().lower, summary().upper};
  search_.fit_slab(extent, all_particles_, exchange_->layers_within(search_.grid(), extent));
  uint32_t count = p.sorted();
  if (!has_all_particles_) {
    std::vector<WordArray> arrays = p.source_arrays();
    if (prediction.limited.count)
      arrays.push_back(
          {reinterpret_cast<uint32_t*>(p.predicted.view().data), sizeof(Vec4) / sizeof(uint32_t)});
    for (ConstraintSet<D>* set : sets_) set->add_carried(arrays);
    count = exchange_->send(prediction, search_.grid(), count, arrays);
  }
  const CellOrder order = search_.sort(prediction, p.source().number.first(count));
  const auto [owned, ghosts] = search_.count_slab();
  rank_ghosts_ = ghosts;
  p.set_sorted(owned + ghosts);
  return order;
}

template <class D>
void Solver<D>::share(Ranks& ranks, const CutPolicy& policy) {
  const bool along_y = std::fabs(parameters_.gravity.z) > std::fabs(parameters_.gravity.y);
  exchange_.emplace(device_, ranks, along_y);
  exchange_->set_policy(policy);
  exchange_->reserve(particles_.capacity());
  has_all_particles_ = true;
  all_particles_ = particles_.sorted();
  exchange_->cut_all(particles_.view(), search_.grid(), {summary().lower, summary().upper});
  sort(predict(0, {}));
  reorder(search_.order(), particles_.sorted());
  has_all_particles_ = false;
  has_found_ = false;
  summary_state_ = SummaryState::unknown;
  keep_own_room();
}

/// Gives back the room for particles of others.
template <class D>
void Solver<D>::keep_own_room() {
  Room room = room_;
  room.fluid = room_for_own(particles_.sorted() + rank_ghosts_);
  reserve_or_stay(room);
  contacts_.shrink(room.fluid);
}

template <class D>
void Solver<D>::reserve_own(uint32_t more) {
  const uint32_t needed = particles_.sorted() + more;
  if (needed > room_.fluid) reserve(room_for_own(needed));
}

/// Repeats work whenever a rank had no room for what others sent. All ranks do so. The work has restored the
/// state by then.
template <class D>
template <class Work>
decltype(auto) Solver<D>::with_room_on_all_ranks(const Work& work) {
  for (;;) {
    try {
      return work();
    } catch (const LacksRoom& lacks) {
      reserve(lacks.needed > room_.fluid ? room_for_own(lacks.needed) : 0);
    }
  }
}

/// The summary of all ranks. Each merges them in the same order.
template <class D>
void Solver<D>::merge_over_ranks() {
  ParticleSummary merged = solver_kernels::empty_summary();
  for (const ParticleSummary& of_rank : values_of_all(exchange_->ranks(), readout_.summary))
    merged = solver_kernels::MergeSummaries{}(merged, of_rank);
  readout_.summary = merged;
}

template <class D>
void Solver<D>::add_results_of_ranks(StepResult& result) {
  const std::vector<StepResult> all = values_of_all(exchange_->ranks(), result);
  result.contacts = 0;
  for (const StepResult& of_rank : all) {
    result.contacts += of_rank.contacts;
    result.max_neighbours = std::max(result.max_neighbours, of_rank.max_neighbours);
  }
}

}  // namespace meniscus::pbd
