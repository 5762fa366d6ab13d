// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How a step runs. Read substep() first: it is the algorithm.
//
// A substep follows Position Based Fluids (Macklin & Müller 2013, algorithm 1) with the small steps of
// Macklin et al. 2019. Positions are predicted, and neighbours and contacts are found once. The constraint
// sets then correct the positions in turn for a number of iterations. The velocity follows from the change of
// the positions. The host waits at the end of the step, and with rigid bodies once in each substep. If
// neighbours or contacts exceeded their capacity, the capacity grows, and the step is repeated from the saved
// state.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "pbd/contact_arrays.inl"
#include "pbd/neighbour_search.inl"
#include "pbd/solver.h"
#include "pbd/solver_kernels.h"
#include "pbd/tuning.h"

namespace meniscus::pbd {

template <class D>
void Solver<D>::substep(float dt, bool is_first, bool is_last) {
  timer_.enter(StageId::predict);
  for (ConstraintSet<D>* set : sets_) set->predict(dt);
  sort(predict(dt, parameters_.gravity));
  // The device is idle, and can begin while the other launches are collected.
  if (is_first && particles_.sorted()) device_.send_off();

  Substep<D> s = make_substep(dt);
  s.gravity = parameters_.gravity;
  s.is_last = is_last;
  for (ConstraintSet<D>* set : sets_) set->arrange(s);
  find(s, std::any_of(sets_.begin(), sets_.end(), [](const auto* set) { return set->prepares(); }));

  timer_.enter(StageId::solve);
  for (ConstraintSet<D>* set : sets_) set->accelerate(s);
  for (ConstraintSet<D>* set : sets_) set->begin(s);
  for (int iteration = 0; iteration < parameters_.iterations; ++iteration) {
    for (ConstraintSet<D>* set : sets_) set->project(s, iteration);
  }

  timer_.enter(StageId::velocity);
  if (is_fast(dt)) contacts_.limit_motion(motion_of(s), true);
  for (ConstraintSet<D>* set : sets_) set->settle(s);
  update_velocities(s);
  for (ConstraintSet<D>* set : sets_) set->end(s);
  for (VelocityPass<D>* pass : passes_) pass->apply(s, particles_);
  for (Observer<D>* observer : observers_) observer->observe(s);

  for (ConstraintSet<D>* set : sets_) {
    if (!set->exchanges()) continue;
    timer_.enter_now(StageId::exchange);
    set->exchange(s);
  }
}

template <class D>
StepResult Solver<D>::step(float dt) {
  for (;;) {
    reserve_extra();
    StepResult result = run(dt);
    const bool done = had_room();
    if (!done || result.summary.non_finite) {
      undo_or_lose([&] { undo_step(); });
    } else {
      fresh_ = false;
      has_found_ = true;
    }
    if (done) return result;
    make_room();
  }
}

/// Runs the substeps of a step of length dt, and returns their results. After an exception the state is the
/// one before.
template <class D>
StepResult Solver<D>::run(float dt) {
  timer_.start_step();
  save_state();
  try {
    const CallMonitor::Cancellable undone_below(device_.monitor());
    start_sets();
    for (Observer<D>* observer : observers_) observer->start_step();
    int substeps = choose_substeps(dt);
    for (ConstraintSet<D>* set : sets_) substeps = set->least_substeps(dt, substeps, particles_.source());
    for (int k = 0; k < substeps; ++k) {
      device_.monitor().poll("step", static_cast<double>(k) / substeps);
      substep(dt / static_cast<float>(substeps), k == 0, k + 1 == substeps);
    }
    timer_.enter(StageId::finish);
    summarize();
    timer_.stop();
    for (ConstraintSet<D>* set : sets_) set->end_step();
    const ParticleSummary& after = summary();
    return {substeps, readout_.found.contacts.last, readout_.found.longest_list, after};
  } catch (...) {
    undo_or_lose([&] { undo_step(); });
    throw;
  }
}

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

// ---- the stages ----

template <class D>
solver_kernels::Prediction Solver<D>::predict(float dt, Vec3 gravity) {
  const ParticleView from = particles_.source();
  solver_kernels::Prediction prediction{from.position, from.velocity, gravity, dt};
  if (dt == 0 || !contacts_.limits_motion()) return prediction;
  const View<Vec4> predicted = particles_.predicted.view();
  device_.parallel_for("predict", from.owned, solver_kernels::Predict{prediction, predicted});
  contacts_.limit_motion({from.position, predicted, {}, from.phase, from.owned, from.sorted}, false);
  prediction.limited = predicted;
  return prediction;
}

template <class D>
void Solver<D>::sort(const solver_kernels::Prediction& prediction) {
  Particles& p = particles_;
  CellOrder order{};
  if (p.sorted()) {
    search_.fit({summary().lower, summary().upper}, p.sorted());
    order = search_.sort(prediction, p.source().slot.first(p.sorted()));
  }
  const ParticleView from = p.source();
  device_.parallel_for(
      "reorder", p.count(),
      solver_kernels::Reorder{order, prediction, from.phase, from.slot, from.number, p.target(p.position),
                              p.previous.view(), p.accumulated_delta.view(), p.target(p.velocity),
                              p.target(p.phase), p.target(p.slot), p.target(p.number), search_.coarse(),
                              search_.grid()});
  p.accept_sorted();
}

/// Contacts are found while neighbours are listed and sets prepare.
template <class D>
void Solver<D>::find(Substep<D>& s, bool prepares) {
  has_found_ = false;
  s.neighbours = search_.view(particles_.sentinel());
  s.grid = search_.grid();
  const bool lists = s.particles.sorted > 0;
  timer_.enter(lists ? StageId::neighbours : StageId::contacts);
  StepReadout* const readout = readout_buffer_.view().data;
  const auto others = [&] {
    if (lists) search_.list(s.particles, particles_.sentinel(), {&readout->found.longest_list, 1});
    if (!prepares) return;
    for (ConstraintSet<D>* set : sets_) set->prepare(s);
  };
  const auto find_contacts = [&] {
    reorder(search_.order(), s.particles.sorted);
    if (lists && !D::runs_at_once) timer_.enter(StageId::contacts);
    contacts_.find(s, {&readout->found.contacts, 1});
  };
  lists || prepares ? device_.at_once(others, find_contacts) : find_contacts();
  contacts_.part_neighbours(s);
  s.contacts = contacts_.view();
}

/// Finds neighbours and contacts at the present positions, with room for all of them.
template <class D>
Substep<D> Solver<D>::find_at_rest(float dt) {
  for (;;) {
    timer_.start_step();
    sort(predict(0, {}));
    Substep<D> s = make_substep(dt);
    find(s, false);
    readout_buffer_.read(std::span(&readout_, 1));
    if (had_room()) return s;
    make_room();
  }
}

/// Whether everything that was found had room.
template <class D>
bool Solver<D>::had_room() {
  const Found& found = readout_.found;
  return found.longest_list <= search_.row_capacity() && found.contacts.most < contacts_.capacity() &&
         std::all_of(sets_.begin(), sets_.end(), [](ConstraintSet<D>* set) { return set->had_room(); });
}

/// Without room for all contacts the rest of the step works with an arbitrary part of them. So what else it
/// found says nothing.
template <class D>
void Solver<D>::make_room() {
  const Found found = std::exchange(readout_.found, {});
  readout_buffer_.write(std::span<const StepReadout>(&readout_, 1), 0);
  if (found.contacts.most >= contacts_.capacity()) return contacts_.grow();
  if (found.longest_list > search_.row_capacity()) search_.grow_rows(found.longest_list);
  for (ConstraintSet<D>* set : sets_) {
    if (!set->had_room()) set->make_room();
  }
}

template <class D>
void Solver<D>::update_velocities(const Substep<D>& s) {
  device_.parallel_for("velocity/update", s.particles.owned,
                       solver_kernels::UpdateVelocity{s.particles.position, s.particles.accumulated_delta,
                                                      s.particles.velocity, 1.0f / s.dt, s.particles.sorted});
}

template <class D>
MotionView Solver<D>::motion_of(const Substep<D>& s) {
  return {s.particles.previous, s.particles.position, s.particles.accumulated_delta,
          s.particles.phase,    s.particles.owned,    s.particles.sorted};
}

/// Whether a substep is long relative to the speeds. The solve may then move a particle through a surface
/// that was out of its reach when contacts were found. New particles may overlap, and be separated at high
/// speed.
template <class D>
bool Solver<D>::is_fast(float dt) const {
  return fresh_ || step_speed_ * dt > contact_tuning::fast_motion *
                                          (parameters_.support_radius - parameters_.contact_radius);
}

template <class D>
int Solver<D>::choose_substeps(float dt) {
  step_speed_ = std::sqrt(summary().max_speed2) + dt * length(parameters_.gravity);
  for (ConstraintSet<D>* set : sets_) step_speed_ = std::fmax(step_speed_, set->speed(dt));
  if (parameters_.cfl_number <= 0) return parameters_.substeps;
  const float wanted = std::ceil(step_speed_ * dt / (parameters_.cfl_number * parameters_.support_radius));
  return static_cast<int>(std::clamp(wanted, static_cast<float>(parameters_.min_substeps),
                                     static_cast<float>(parameters_.max_substeps)));
}

// ---- state ----

template <class D>
Solver<D>::Solver(D& device, Particles& particles, const SolverParameters& parameters)
    : device_(device),
      particles_(particles),
      parameters_(parameters),
      search_(device, parameters.support_radius),
      contacts_(device),
      timer_(device) {
  readout_buffer_.resize_discard(1);
  readout_buffer_.fill(0);
}

template <class D>
void Solver<D>::reserve(uint32_t fluid, uint32_t vertices) {
  if (fluid <= fluid_room_ && vertices <= vertex_room_) return;
  const uint32_t more_fluid = std::max(fluid, fluid_room_), more_vertices = std::max(vertices, vertex_room_);
  try {
    reserve_all(more_fluid, more_vertices);
  } catch (...) {
    undo_or_lose([&] { reserve_all(fluid_room_, vertex_room_); });
    throw;
  }
  fluid_room_ = more_fluid;
  vertex_room_ = more_vertices;
}

template <class D>
void Solver<D>::reserve_all(uint32_t fluid, uint32_t vertices) {
  has_found_ = false;
  const uint32_t capacity = fluid + vertices + extra_room_;
  const uint32_t with_state = fluid ? capacity : 0;
  for (ConstraintSet<D>* set : sets_) set->reserve(with_state, particles_.sorted());
  for (VelocityPass<D>* pass : passes_) pass->reserve(with_state);
  particles_.reserve(capacity, fluid > 0);
  search_.reserve(fluid);
  contacts_.reserve(capacity);
}

/// Makes room for the particles that sets add in a substep. The state must be in place, not saved.
template <class D>
void Solver<D>::reserve_extra() {
  uint32_t extra = 0;
  for (const ConstraintSet<D>* set : sets_) extra += set->extra_particles();
  if (extra <= extra_room_) return;
  const uint32_t before = std::exchange(extra_room_, extra);
  try {
    reserve_all(fluid_room_, vertex_room_);
  } catch (...) {
    extra_room_ = before;
    undo_or_lose([&] { reserve_all(fluid_room_, vertex_room_); });
    throw;
  }
}

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
  if (summary_state_ == SummaryState::on_device) readout_buffer_.read(std::span(&readout_, 1));
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
Substep<D> Solver<D>::make_substep(float dt) {
  return {device_, particles_.view(), {}, {}, dt, parameters_.iterations};
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
  } catch (...) {
    throw StateLost();
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
void Solver<D>::restore_state() {
  particles_.restore();
  for (ConstraintSet<D>* set : sets_) set->restore();
  summary_state_ = SummaryState::unknown;
}

}  // namespace meniscus::pbd
