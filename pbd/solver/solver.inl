// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How a substep runs. Read substep() first: it is the algorithm. pbd/solver/ has what surrounds it.
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

#include "pbd/contact_arrays.inl"
#include "pbd/neighbour_search.inl"
#include "pbd/rank_exchange.inl"
#include "pbd/seam_ghosts.inl"
#include "pbd/solver.h"
#include "pbd/solver/over_ranks.inl"
#include "pbd/solver/place_cuts.inl"
#include "pbd/solver/relax.inl"
#include "pbd/solver/room.inl"
#include "pbd/solver/step.inl"
#include "pbd/solver/summary.inl"
#include "pbd/solver/worlds.inl"
#include "pbd/solver_kernels.h"
#include "pbd/tuning.h"

namespace meniscus::pbd {

template <class D>
void Solver<D>::substep(float dt, bool is_first, bool is_last) {
  timer_.enter(StageId::predict);
  for (ExternalForces<D>* forces : forces_) forces->start_substep(dt);
  for (ConstraintSet<D>* set : sets_) set->predict(dt);
  sort(predict(dt, parameters_.gravity));
  // The device is idle, and can begin while the other launches are collected.
  if (is_first && particles_.sorted()) device_.send_off();

  Substep<D> s = make_substep(dt);
  s.iterations = step_iterations_;
  s.gravity = parameters_.gravity;
  s.is_last = is_last;
  call_hook(Hook::predicted, s);
  for (ConstraintSet<D>* set : sets_) set->arrange(s);
  find(s, std::any_of(sets_.begin(), sets_.end(), [](const auto* set) { return set->prepares(); }));

  timer_.enter(StageId::solve);
  for (ConstraintSet<D>* set : sets_) set->accelerate(s);
  for (ConstraintSet<D>* set : sets_) set->begin(s);
  call_hook(Hook::contacts_found, s);
  for (int iteration = 0; iteration < s.iterations; ++iteration) {
    for (ConstraintSet<D>* set : sets_) set->project(s, iteration);
    call_hook(Hook::iterated, s, iteration);
  }

  timer_.enter(StageId::velocity);
  if (is_fast(dt)) contacts_.limit_motion(motion_of(s), true);
  for (ConstraintSet<D>* set : sets_) set->settle(s);
  call_hook(Hook::solved, s);
  refresh_ghost_positions(device_, s.ghosts, s.particles.position);
  update_velocities(s);
  for (ConstraintSet<D>* set : sets_) set->end(s);
  for (VelocityPass<D>* pass : passes_) pass->apply(s, particles_);
  call_hook(Hook::velocities_known, s);
  for (Observer<D>* observer : observers_) observer->observe(s);

  for (ConstraintSet<D>* set : sets_) {
    if (!set->exchanges()) continue;
    timer_.enter_now(StageId::exchange);
    set->exchange(s);
  }
}

template <class D>
solver_kernels::Prediction Solver<D>::predict(float dt, Vec3 gravity) {
  const ParticleView from = particles_.source();
  solver_kernels::Prediction prediction{from.position, from.velocity, gravity, dt};
  if (dt > 0) prediction.changes = velocity_changes(from, dt);
  if (dt > 0 && gravities_.count) {
    prediction.gravities = {gravities_, particles_.sorted() / worlds_};
    prediction.vertex_gravities = {gravities_, vertices_of_world()};
    prediction.sorted = particles_.sorted();
  }
  if (dt == 0 || !contacts_.limits_motion()) return prediction;
  const View<Vec4> predicted = particles_.predicted.view();
  device_.parallel_for("predict", from.owned, solver_kernels::Predict{prediction, predicted});
  contacts_.limit_motion({from.position, predicted, {}, from.phase, from.owned, from.sorted}, false);
  prediction.limited = predicted;
  return prediction;
}

/// What external forces add to the velocities. One part at most has forces on particles.
template <class D>
View<const Vec4> Solver<D>::velocity_changes(const ParticleView& start, float dt) {
  for (ExternalForces<D>* forces : forces_) {
    if (forces->any()) return forces->velocity_changes(start, dt);
  }
  return {};
}

template <class D>
void Solver<D>::sort(const solver_kernels::Prediction& prediction) {
  Particles& p = particles_;
  CellOrder order{};
  search_.set_own_cells(needs_own_cells());
  const bool has_seams = ghosts_.any() && p.sorted();
  if (exchange_) {
    order = order_among_ranks(prediction);
  } else if (p.sorted()) {
    using Wrapped = seam_kernels::Wrapped<solver_kernels::Prediction>;
    search_.set_layers(has_layers_along_y(parameters_.gravity));
    search_.fit(table_extent(), p.sorted());
    const View<const uint32_t> number = p.source().number.first(p.sorted());
    order = has_seams ? search_.sort(Wrapped{prediction, ghosts_.axes()}, number)
                      : search_.sort(prediction, number);
  }
  const ParticleView from = p.source();
  device_.parallel_for(
      "reorder", p.count(),
      solver_kernels::Reorder{order, prediction, from.phase, from.slot, from.number, p.target(p.position),
                              p.previous.view(), p.accumulated_delta.view(), p.target(p.velocity),
                              p.target(p.phase), p.target(p.slot), p.target(p.number), search_.coarse(),
                              search_.grid()});
  p.accept_sorted();
  if (exchange_) {
    p.set_sorted(p.sorted() - rank_ghosts_);
    exchange_->note_sorted(p.view().position, search_.grid(), p.sorted(), rank_ghosts_);
  }
  if (!has_seams) return;
  ghosts_.wrap(p, search_.coarse(), search_.grid());
  ghosts_.make(p, {summary().lower, summary().upper}, {&readout_buffer_.view().data->found.ghosts, 1});
}

template <class D>
bool Solver<D>::needs_own_cells() const {
  return std::any_of(sets_.begin(), sets_.end(), [](const auto* set) { return set->needs_own_cells(); });
}

/// The extent for which the table of cells is shaped. Where ranks may share a world whose cells must not
/// share entries, it has room along the axis of slabs for the motion of a step: see
/// NeighbourSearch::has_own_layers. The world alone has the same table then.
template <class D>
Aabb Solver<D>::table_extent() {
  const Aabb extent{summary().lower, summary().upper};
  if (!needs_own_cells() || !device_.fixes_sums()) return extent;
  const float room = step_motion_ + 1.5f * parameters_.support_radius;
  const Vec3 margin = has_layers_along_y(parameters_.gravity) ? Vec3{0, room, 0} : Vec3{0, 0, room};
  return {extent.lower - margin, extent.upper + margin};
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
    const View<uint32_t> longest{&readout->found.longest_list, 1};
    if (lists) search_.list(s.particles, particles_.sentinel(), longest);
    if (lists && ghosts_.any()) ghosts_.list(s.particles, s.neighbours, longest);
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
/// speed. With fixed sums every substep counts as long, as a particle must not depend on the speed of others.
template <class D>
bool Solver<D>::is_fast(float dt) const {
  return device_.fixes_sums() || fresh_ ||
         step_speed_ * dt >
             contact_tuning::fast_motion * (parameters_.support_radius - parameters_.contact_radius);
}

template <class D>
int Solver<D>::choose_substeps(float dt) {
  float acceleration = length(parameters_.gravity);
  for (const ExternalForces<D>* forces : forces_)
    acceleration += forces->greatest_acceleration(summary().lower, summary().upper);
  step_speed_ = std::sqrt(summary().max_speed2) + dt * acceleration;
  for (ConstraintSet<D>* set : sets_) step_speed_ = std::fmax(step_speed_, set->speed(dt));
  step_motion_ = step_speed_ * dt;
  if (parameters_.cfl_number <= 0) return parameters_.substeps;
  const float wanted = std::ceil(step_speed_ * dt / (parameters_.cfl_number * parameters_.support_radius));
  return static_cast<int>(std::clamp(wanted, static_cast<float>(parameters_.min_substeps),
                                     static_cast<float>(parameters_.max_substeps)));
}

template <class D>
Substep<D> Solver<D>::make_substep(float dt) {
  Substep<D> s{device_, particles_.view(), {}, {}, dt, parameters_.iterations};
  if (ghosts_.any() && s.particles.sorted) s.ghosts = ghosts_.view();
  s.particles.ghosts = s.ghosts.source.count;
  if (!exchange_) return s;
  s.ghosts.exchange = &*exchange_;
  s.particles.ghosts = rank_ghosts_;
  return s;
}

template <class D>
Solver<D>::Solver(D& device, Particles& particles, const SolverParameters& parameters)
    : device_(device),
      particles_(particles),
      parameters_(parameters),
      search_(device, parameters.support_radius),
      contacts_(device),
      ghosts_(device, parameters.periodic, parameters.support_radius),
      kept_world_(device, particles),
      kept_vertices_(device, particles),
      timer_(device) {
  device_.fix_sums(parameters.fixed_sums);
  readout_buffer_.resize_discard(1);
  readout_buffer_.fill(0);
}

}  // namespace meniscus::pbd
