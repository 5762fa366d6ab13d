// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a solver knows about its particles, and its part of a snapshot.
#pragma once

#include <algorithm>
#include <span>

#include "pbd/solver.h"
#include "pbd/solver_kernels.h"

namespace meniscus::pbd {

template <class D>
void Solver<D>::particles_changed(uint32_t first, uint32_t count) {
  summary_state_ = SummaryState::unknown;
  has_found_ = false;
  fresh_ = true;
  for (ConstraintSet<D>* set : sets_) set->clear(first, count);
}

template <class D>
const ParticleSummary& Solver<D>::summary() {
  if (summary_state_ == SummaryState::unknown) summarize();
  if (summary_state_ == SummaryState::on_device) {
    readout_buffer_.read(std::span(&readout_, 1));
    if (exchange_) merge_over_ranks();
  }
  summary_state_ = SummaryState::known;
  return readout_.summary;
}

template <class D>
void Solver<D>::summarize() {
  using namespace solver_kernels;
  const ParticleView p = particles_.view();
  device_.reduce("summary", p.owned, empty_summary(), Summarize{p.position, p.velocity, p.slot},
                 MergeSummaries{}, View<ParticleSummary>{&readout_buffer_.view().data->summary, 1});
  summary_state_ = SummaryState::on_device;
}

template <class D>
void Solver<D>::visit_state(StateVisitor& v) {
  Room room = room_;
  v.value("room", room);
  if (v.restores()) {
    room = {std::max(room.fluid, room_.fluid), std::max(room.vertices, room_.vertices),
            std::max(room.extra, room_.extra), std::max(room.ghosts, room_.ghosts)};
    if (room != room_) reserve_or_stay(room);
  }
  v.part("particles", particles_);
  v.value("fresh", fresh_);
  if (!v.restores()) return;
  summary_state_ = SummaryState::unknown;
  has_found_ = false;
}

}  // namespace meniscus::pbd
