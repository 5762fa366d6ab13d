// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The room for particles, in all parts of a solver.
#pragma once

#include <algorithm>

#include "pbd/solver.h"
#include "pbd/solver_kernels.h"

namespace meniscus::pbd {

template <class D>
void Solver<D>::reserve(uint32_t fluid, uint32_t vertices) {
  if (fluid <= room_.fluid && vertices <= room_.vertices) return;
  Room room = room_;
  room.fluid = std::max(fluid, room.fluid);
  room.vertices = std::max(vertices, room.vertices);
  if (ghosts_.any()) room.ghosts = std::max(room.ghosts, ghosts_.expected(room.fluid));
  reserve_or_stay(room);
}

/// If there is not enough memory, the room is as before.
template <class D>
void Solver<D>::reserve_or_stay(const Room& room) {
  try {
    reserve_all(room);
  } catch (...) {
    undo_or_lose([&] { reserve_all(room_); });
    throw;
  }
  room_ = room;
}

template <class D>
void Solver<D>::reserve_all(const Room& room) {
  has_found_ = false;
  const uint32_t owned = room.fluid + room.vertices + room.extra, capacity = owned + room.ghosts;
  const uint32_t with_state = room.fluid ? capacity : 0;
  for (ConstraintSet<D>* set : sets_) set->reserve(with_state, particles_.sorted());
  for (VelocityPass<D>* pass : passes_) pass->reserve(with_state);
  for (ExternalForces<D>* forces : forces_) forces->reserve(capacity);
  particles_.reserve(capacity, room.fluid > 0);
  search_.reserve(room.fluid);
  contacts_.reserve(owned);
  if (ghosts_.any()) ghosts_.reserve(room.fluid, room.ghosts);
  if (exchange_) exchange_->reserve(capacity);
}

/// Makes room for the particles that sets add in a substep. The state must be in place, not saved.
template <class D>
void Solver<D>::reserve_extra() {
  uint32_t extra = 0;
  for (const ConstraintSet<D>* set : sets_) extra += set->extra_particles();
  if (extra <= room_.extra) return;
  Room room = room_;
  room.extra = extra;
  reserve_or_stay(room);
}

}  // namespace meniscus::pbd
