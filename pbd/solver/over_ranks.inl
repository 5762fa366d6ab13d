// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// One world over many ranks: what a solver does differently there. See pbd/rank_exchange.h.
#pragma once

#include <meniscus/error.h>

#include <algorithm>
#include <string>
#include <vector>

#include "pbd/solver.h"
#include "pbd/solver_kernels.h"

namespace meniscus::pbd {

/// The room of a rank that needs this much: a sixteenth more, since particles come and go.
inline uint32_t room_for_own(uint32_t needed) {
  constexpr uint32_t least = 1024;
  return std::max(needed + needed / 16, least);
}

[[noreturn]] inline void refuse_layers(uint32_t layers) {
  throw Error(ErrorCode::capacity,
              "the fluid reaches over " + std::to_string(layers) +
                  " layers of cells along the axis of its slabs, more than its pressure grid has room for; a "
                  "sink can remove what is far away");
}

/// Sends particles to the ranks that own their predicted positions, or have them as ghosts. The particles
/// that this rank then needs count as sorted: its own, and behind them the ghosts.
template <class D>
CellOrder Solver<D>::order_among_ranks(const solver_kernels::Prediction& prediction) {
  Particles& p = particles_;
  search_.set_part(exchange_->region());
  const Aabb extent = table_extent();
  uint32_t count = p.sorted();
  if (needs_own_cells()) {
    const auto layers = exchange_->find_layers(prediction, search_.grid(), count);
    search_.fit_part(extent, all_particles_, {layers.own, layers.own});
    if (!search_.has_own_layers(layers.all)) refuse_layers(layers.all);
  } else {
    search_.fit_part(extent, all_particles_, exchange_->layers_within(search_.grid(), extent));
  }
  if (!has_all_particles_) {
    std::vector<WordArray> arrays = p.source_arrays();
    if (prediction.limited.count)
      arrays.push_back(
          {reinterpret_cast<uint32_t*>(p.predicted.view().data), sizeof(Vec4) / sizeof(uint32_t)});
    for (ConstraintSet<D>* set : sets_) set->add_carried(arrays);
    count = exchange_->send(prediction, search_.grid(), count, arrays);
  }
  const CellOrder order = search_.sort(prediction, p.source().number.first(count));
  const auto [owned, ghosts] = search_.count_part();
  rank_ghosts_ = ghosts;
  p.set_sorted(owned + ghosts);
  return order;
}

template <class D>
void Solver<D>::join(Ranks& ranks, const CutPolicy& policy) {
  const bool along_y = has_layers_along_y(parameters_.gravity);
  search_.set_layers(along_y);
  exchange_.emplace(device_, ranks, along_y);
  exchange_->set_policy(policy);
  exchange_->reserve(particles_.capacity());
  summary_state_ = SummaryState::unknown;  // on some ranks it may be known
}

template <class D>
void Solver<D>::share(Ranks& ranks, const CutPolicy& policy) {
  join(ranks, policy);
  all_particles_ = particles_.sorted();
  exchange_->cut_all(particles_.view(), search_.grid(), {summary().lower, summary().upper});
  keep_own();
}

template <class D>
void Solver<D>::cut(Ranks& ranks, const CutPolicy& policy, std::span<const Vec4> positions) {
  join(ranks, policy);
  all_particles_ = static_cast<uint32_t>(positions.size());
  exchange_->cut_all(positions, search_.grid());
  search_.set_part(exchange_->region());
}

template <class D>
void Solver<D>::keep_own() {
  has_all_particles_ = true;
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
