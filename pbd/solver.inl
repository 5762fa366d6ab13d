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
#include "pbd/rank_exchange.inl"
#include "pbd/seam_ghosts.inl"
#include "pbd/solver.h"
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
void Solver<D>::begin_step(float dt, int iterations) {
  step_iterations_ = iterations;
  reserve_extra();
  run(dt);
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
  if (dt > 0) prediction.changes = velocity_changes(from, dt);
  if (dt > 0 && gravities_.count) prediction.gravities = {gravities_, particles_.sorted() / worlds_};
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
  const bool has_seams = ghosts_.any() && p.sorted();
  if (exchange_) {
    order = order_among_ranks(prediction);
  } else if (p.sorted()) {
    using Wrapped = seam_kernels::Wrapped<solver_kernels::Prediction>;
    search_.fit({summary().lower, summary().upper}, p.sorted());
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

/// Sends particles to the ranks that own their predicted positions, or have them as ghosts. The particles
/// that this rank then needs count as sorted: its own, and behind them the ghosts.
template <class D>
CellOrder Solver<D>::order_among_ranks(const solver_kernels::Prediction& prediction) {
  Particles& p = particles_;
  search_.set_slab(exchange_->layers_along_y(), exchange_->first_layer(), exchange_->end_layer());
  search_.fit({summary().lower, summary().upper}, room_.fluid);  // the same shape on all ranks
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
  exchange_->cut_all(particles_.view(), search_.grid(), {summary().lower, summary().upper});
  sort(predict(0, {}));
  reorder(search_.order(), particles_.sorted());
  has_all_particles_ = false;
  has_found_ = false;
  summary_state_ = SummaryState::unknown;
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

/// Finds neighbours and contacts at the present positions, with room for all of them.
template <class D>
Substep<D> Solver<D>::find_at_rest(float dt) {
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

/// Whether everything that was found had room.
template <class D>
bool Solver<D>::had_room() {
  const Found& found = readout_.found;
  const bool had = has_ghost_room() && found.longest_list <= search_.row_capacity() &&
                   found.contacts.most < contacts_.capacity() &&
                   std::all_of(sets_.begin(), sets_.end(), [](auto* set) { return set->had_room(); });
  if (!exchange_) return had;
  return std::ranges::all_of(values_of_all(exchange_->ranks(), uint32_t{had}),
                             [](uint32_t all) { return all; });
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
      ghosts_(device, parameters.periodic, parameters.support_radius),
      kept_world_(device, particles),
      timer_(device) {
  device_.fix_sums(parameters.fixed_sums);
  readout_buffer_.resize_discard(1);
  readout_buffer_.fill(0);
}

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
    if (exchange_ && !has_all_particles_) merge_over_ranks();
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

// ---- batches of worlds ----

template <class D>
void Solver<D>::make_worlds(uint32_t worlds) {
  const uint32_t each = particles_.sorted();
  kept_world_.keep(each);
  for (ConstraintSet<D>* set : sets_) set->keep_world(each);
  search_.set_worlds(worlds, each);
  Room room = room_;
  room.fluid = std::max(room.fluid, worlds * each);
  reserve_or_stay(room);
  particles_.set_sorted(worlds * each);
  worlds_ = worlds;
  reset_worlds({});
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
}

template <class D>
void Solver<D>::undo_worlds(View<const uint32_t> chosen) {
  change_worlds(chosen, [](auto& part, const ChosenWorlds& worlds) { part.undo_worlds(worlds); });
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
