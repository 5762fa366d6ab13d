// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Solves without passage of time: relaxation, measurement, and the neighbours that they need.
#pragma once

#include <functional>
#include <span>

#include "pbd/solver.h"
#include "pbd/solver_kernels.h"

namespace meniscus::pbd {

template <class D>
void Solver<D>::relax(float dt, int times) {
  relax_and(dt, times, [&](const Substep<D>& s) {
    device_.parallel_for("relax/stop", s.particles.owned, solver_kernels::StopMotion{s.particles.velocity});
  });
}

template <class D>
void Solver<D>::relax_from(uint32_t first, float dt, int times) {
  relax_and(dt, times, [&](const Substep<D>& s) {
    const ParticleView& p = s.particles;
    device_.parallel_for("relax/hold", p.owned,
                         solver_kernels::HoldOthers{p.slot, p.sorted, first, p.previous, p.position});
  });
}

/// Calls finish(substep) after each of the solves.
template <class D>
template <class Finish>
void Solver<D>::relax_and(float dt, int times, const Finish& finish) {
  for (int k = 0; k < times;) {
    save_state();
    try {
      const CallMonitor::Cancellable undone_below(device_.monitor());
      device_.monitor().poll("relax", static_cast<double>(k) / times);
      start_sets();
      finish(relax_once(dt));
      if (ghosts_.any()) ghosts_.wrap(particles_, {}, {});
      device_.wait();  // some sets find only while they work that they lack room
    } catch (...) {
      undo_or_lose([&] { undo_step(); });
      throw;
    }
    if (had_room()) {
      for (ConstraintSet<D>* set : sets_) set->undo_step();  // no time has passed
      particles_changed(0, particles_.sorted());
      ++k;
    } else {
      undo_or_lose([&] { undo_step(); });
      make_room();
    }
  }
}

template <class D>
Substep<D> Solver<D>::relax_once(float dt) {
  Substep<D> s = find_at_rest(dt);
  for (ConstraintSet<D>* set : sets_) set->begin(s);
  for (int iteration = 0; iteration < parameters_.iterations; ++iteration) {
    for (ConstraintSet<D>* set : sets_) set->project(s, iteration);
  }
  contacts_.limit_motion(motion_of(s), true);
  for (ConstraintSet<D>* set : sets_) set->settle(s);
  return s;
}

template <class D>
void Solver<D>::measure(const std::function<void(Substep<D>&, const Found&)>& measure) {
  with_room_on_all_ranks([&] {
    save_state();
    try {
      const CallMonitor::Cancellable restored_below(device_.monitor());
      Substep<D> s = find_at_rest(0);
      measure(s, readout_.found);
    } catch (...) {
      undo_or_lose([&] { restore_state(); });
      throw;
    }
    restore_state();
  });
}

template <class D>
bool Solver<D>::read_last_substep(const std::function<void(Substep<D>&)>& read) {
  if (!has_found_) return false;
  Substep<D> s = make_substep(0);
  s.neighbours = search_.view(particles_.sentinel());
  s.grid = search_.grid();
  s.contacts = contacts_.view();
  read(s);
  return true;
}

/// Finds neighbours and contacts at the present positions, with room for all of them.
template <class D>
Substep<D> Solver<D>::find_at_rest(float dt) {
  step_motion_ = 0;
  for (;;) {
    timer_.start_step();
    sort(predict(0, {}));
    Substep<D> s = make_substep(dt);
    find(s, false);
    const ParticleSummary of_all_ranks = readout_.summary;
    readout_buffer_.read(std::span(&readout_, 1));
    if (exchange_) readout_.summary = of_all_ranks;
    if (had_room()) return s;
    has_ghost_room() ? make_room() : make_room_for_ghosts();
  }
}

/// The arrays of the particles can grow while the state is in place, not saved.
template <class D>
void Solver<D>::make_room_for_ghosts() {
  restore_state();
  try {
    make_room();
  } catch (...) {
    save_state();
    throw;
  }
  save_state();
}

}  // namespace meniscus::pbd
