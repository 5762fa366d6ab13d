// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A step as a whole: its substeps, its repetition where room was missing, and its undoing.
#pragma once

#include <algorithm>
#include <span>
#include <utility>

#include "pbd/solver.h"
#include "pbd/solver_kernels.h"

namespace meniscus::pbd {

template <class D>
void Solver<D>::begin_step(float dt, int iterations) {
  step_iterations_ = iterations;
  reserve_extra();
  with_room_on_all_ranks([&] { run(dt); });
}

template <class D>
StepResult Solver<D>::end_step() {
  for (;;) {
    StepResult result = finish();
    const bool done = had_room();
    if (!done || (result.summary.non_finite && worlds_ == 1)) {
      undo_or_lose([&] { undo_step(); });
    } else {
      fresh_ = false;
      has_found_ = !ghosts_.any();  // particles have been taken across seams since
    }
    if (done) return result;
    make_room();
    begin_step(step_dt_, step_iterations_);
  }
}

/// Launches the substeps of a step of length dt. After an exception the state is the one before.
template <class D>
void Solver<D>::run(float dt) {
  step_dt_ = dt;
  timer_.start_step();
  save_state();
  try {
    const CallMonitor::Cancellable undone_below(device_.monitor());
    start_sets();
    if (exchange_)
      exchange_->balance(particles_.source(), search_.grid(), {summary().lower, summary().upper});
    for (Observer<D>* observer : observers_) observer->start_step();
    for (ExternalForces<D>* forces : forces_) forces->start_step();
    int substeps = choose_substeps(dt);
    for (ConstraintSet<D>* set : sets_) substeps = set->least_substeps(dt, substeps, particles_.source());
    for (int k = 0; k < substeps; ++k) {
      device_.monitor().poll("step", static_cast<double>(k) / substeps);
      substep(dt / static_cast<float>(substeps), k == 0, k + 1 == substeps);
    }
    timer_.enter(StageId::finish);
    if (ghosts_.any()) ghosts_.wrap(particles_, {}, {});
    summarize();
    timer_.stop();
    step_substeps_ = substeps;
  } catch (...) {
    undo_or_lose([&] { undo_step(); });
    throw;
  }
}

/// Waits for the substeps, and returns their results. After an exception the state is the one before them.
template <class D>
StepResult Solver<D>::finish() {
  try {
    const CallMonitor::Cancellable undone_below(device_.monitor());
    for (ConstraintSet<D>* set : sets_) set->end_step();
    const ParticleSummary& after = summary();
    StepResult result{step_substeps_, readout_.found.contacts.last, readout_.found.longest_list, after};
    if (exchange_) add_results_of_ranks(result);
    return result;
  } catch (...) {
    undo_or_lose([&] { undo_step(); });
    throw;
  }
}

/// Whether everything that was found had room.
template <class D>
bool Solver<D>::had_room() {
  const Found& found = readout_.found;
  const bool had = has_ghost_room() && found.longest_list <= search_.row_capacity() &&
                   found.contacts.most < contacts_.capacity() &&
                   std::all_of(sets_.begin(), sets_.end(), [](const auto* set) { return set->had_room(); });
  return exchange_ ? !is_on_any(exchange_->ranks(), !had) : had;
}

/// Without room for all ghosts or contacts the rest of the step works with an arbitrary part of them. So what
/// else it found says nothing.
template <class D>
void Solver<D>::make_room() {
  const bool lacks_ghosts = !has_ghost_room();
  const Found found = std::exchange(readout_.found, {});
  readout_buffer_.write(std::span<const StepReadout>(&readout_, 1), 0);
  if (lacks_ghosts) {
    Room room = room_;
    room.ghosts = found.ghosts.most + found.ghosts.most / 4;
    return reserve_or_stay(room);
  }
  if (found.contacts.most >= contacts_.capacity()) return contacts_.grow();
  if (found.longest_list > search_.row_capacity()) search_.grow_rows(found.longest_list);
  for (ConstraintSet<D>* set : sets_) {
    if (!set->had_room()) set->make_room();
  }
}

template <class D>
void Solver<D>::start_sets() {
  started_ = 0;
  for (ConstraintSet<D>* set : sets_) {
    ++started_;
    set->start_step();
  }
}

template <class D>
void Solver<D>::undo_step() {
  restore_state();
  for (size_t k = 0; k < started_; ++k) sets_[k]->undo_step();
}

template <class D>
void Solver<D>::save_state() {
  summary();  // of the present state, before it is saved
  for (ConstraintSet<D>* set : sets_) set->save();
  particles_.save();
}

/// Runs what takes a failed call back. If this fails as well, there is no state to go on from.
template <class D>
template <class Undo>
void Solver<D>::undo_or_lose(const Undo& undo) {
  try {
    undo();
  } catch (const Error& error) {
    throw StateLost(error);
  } catch (...) {
    throw StateLost();
  }
}

template <class D>
void Solver<D>::restore_state() {
  particles_.restore();
  for (ConstraintSet<D>* set : sets_) set->restore();
  summary_state_ = SummaryState::unknown;
}

}  // namespace meniscus::pbd
