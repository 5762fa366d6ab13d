// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Many worlds in one solver. See pbd/worlds.h.
#pragma once

#include <algorithm>

#include "pbd/solver.h"
#include "pbd/solver_kernels.h"

namespace meniscus::pbd {

template <class D>
void Solver<D>::keep_world(uint32_t pieces) {
  const uint32_t each = particles_.sorted();
  kept_world_.keep(each);
  kept_vertices_.keep(pieces);
  for (ConstraintSet<D>* set : sets_) set->keep_world(each);
}

template <class D>
void Solver<D>::make_worlds(uint32_t worlds) {
  const uint32_t each = particles_.sorted();
  search_.set_worlds(worlds, each);
  Room room = room_;
  room.fluid = std::max(room.fluid, worlds * each);
  room.vertices = std::max(room.vertices, worlds * kept_vertices_.each());
  reserve_or_stay(room);
  particles_.set_sorted(worlds * each);
  worlds_ = worlds;
}

/// Calls change(part, worlds) for all that has arrays of particles.
template <class D>
template <class Change>
void Solver<D>::change_worlds(View<const uint32_t> chosen, const Change& change) {
  const uint32_t count = particles_.sorted();
  const ChosenWorlds worlds{chosen, count / worlds_, count};
  change(kept_world_, worlds);
  for (ConstraintSet<D>* set : sets_) change(*set, worlds);
  summary_state_ = SummaryState::unknown;
  has_found_ = false;
}

template <class D>
void Solver<D>::reset_worlds(View<const uint32_t> chosen) {
  change_worlds(chosen, [](auto& part, const ChosenWorlds& worlds) { part.reset_worlds(worlds); });
  kept_vertices_.reset_worlds(chosen);
}

template <class D>
void Solver<D>::undo_worlds(View<const uint32_t> chosen) {
  change_worlds(chosen, [](auto& part, const ChosenWorlds& worlds) { part.undo_worlds(worlds); });
  kept_vertices_.undo_worlds(chosen);
}

}  // namespace meniscus::pbd
