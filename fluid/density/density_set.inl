// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The iterations of the density constraint, as launches of kernels, and its buffers.
#pragma once

#include <cmath>
#include <utility>

#include "fluid/density/baseline.h"
#include "fluid/density/crowd.h"
#include "fluid/density/density_set.h"
#include "fluid/density/stop.h"
#include "fluid/kernel/density_wall_kernels.h"
#include "fluid/kernel/piston_multipliers.h"
#include "fluid/pressure_grid/pressure_grid.h"
#include "pbd/gather.h"

namespace meniscus::fluid {

template <class D>
DensitySet<D>::DensitySet(D& device, const Kernel& kernel, const DensityParameters& parameters)
    : device_(device),
      kernel_(kernel),
      chebyshev_(parameters.spectral_bound),
      crowd_(std::make_unique<Crowd<D>>(device)) {
  set_parameters(parameters);
}

template <class D>
void DensitySet<D>::set_parameters(const DensityParameters& parameters) {
  const bool changes_grid = parameters.pressure_grid != (pressure_grid_ != nullptr);
  if (!parameters.pressure_grid) {
    pressure_grid_.reset();
  } else if (!pressure_grid_) {
    auto grid = std::make_unique<PressureGrid<D>>(device_, kernel_);
    if (staged_.size()) grid->reserve(static_cast<uint32_t>(staged_.size()));
    pressure_grid_ = std::move(grid);
  }
  if (changes_grid) forget(0, static_cast<uint32_t>(multiplier_.current.size()));
  if (!(parameters.tolerance > 0)) {
    stop_.reset();
  } else if (!stop_) {
    auto stop = std::make_unique<DensityStop<D>>(device_);
    stop->reserve(static_cast<uint32_t>(staged_.size()));
    stop_ = std::move(stop);
  }
  set_baseline(parameters);
  parameters_ = parameters;
  const float bound = std::fmax(parameters.spectral_bound, kernel_.spectral_bound);
  chebyshev_ = pbd::Chebyshev(bound);
  relaxation_ = parameters.relaxation * (parameters.spectral_bound / bound);
}

/// Another method does not start from the multipliers of this one, as they mean something else.
template <class D>
void DensitySet<D>::set_baseline(const DensityParameters& parameters) {
  if (parameters.method == parameters_.method) {
    if (baseline_) baseline_->set_parameters(parameters);
    return;
  }
  auto baseline = make_baseline(device_, kernel_, parameters);
  if (baseline && staged_.size()) {
    const auto size = static_cast<uint32_t>(staged_.size());
    baseline->reserve(size, size - pbd::Particles::padding);
  }
  baseline_ = std::move(baseline);
  if (multiplier_.current.size()) multiplier_.current.fill(0);
}

template <class D>
DensitySet<D>::~DensitySet() = default;

template <class D>
void DensitySet<D>::note_placed(uint32_t first, uint32_t count) {
  crowd_->note_placed(first, count);
}

template <class D>
void DensitySet<D>::start_step() {
  crowd_->start_step();
  if (stop_) stop_->start_step();
  if (baseline_) baseline_->start_step();
}

template <class D>
int DensitySet<D>::least_substeps(float dt, int chosen, const pbd::ParticleView& start) {
  return baseline_ ? baseline_->least_substeps(dt, chosen, start) : chosen;
}

template <class D>
uint32_t DensitySet<D>::iterations_done(uint32_t planned) const {
  if (baseline_) return baseline_->iterations_done(planned);
  return stop_ ? stop_->iterations() : planned;
}

template <class D>
void DensitySet<D>::begin(pbd::Substep<D>& substep) {
  extrapolates_ = false;
  const float ratio = last_dt_ > 0 ? substep.dt / last_dt_ : 0;
  last_dt_ = substep.dt;
  const bool relaxes = std::exchange(relaxes_, true);
  by_baseline_ = baseline_ && !relaxes && any_fluid_ && substep.particles.sorted > 0;
  if (by_baseline_) {
    allowed_ = {};
    return baseline_->begin(substep, multiplier_.current.view(), ratio * ratio);
  }
  // A multiplier grows with the square of the step. But after a step that was short for its error, the
  // multiplier exceeds that of a longer step. With a pressure grid the multipliers include its pressure, so
  // they are no estimate for the remaining iterations.
  warm_start_fraction_ = pressure_grid_ ? 0 : parameters_.warm_start * std::fmin(1.0f, ratio * ratio);
  const float limit = relaxes ? parameters_.correction_limit * static_cast<float>(substep.iterations)
                              : parameters_.parting_speed * substep.dt;
  allowed_ = !any_fluid_ ? pbd::View<const float>{} : with_shape(kernel_, [&](const auto& kernel) {
    return crowd_->part(substep, kernel, parameters_.spacing, limit);
  });
}

template <class D>
void DensitySet<D>::project(pbd::Substep<D>& substep, int iteration) {
  using namespace density_kernels;
  if (by_baseline_) return baseline_->project(substep, multiplier_.current.view(), iteration);
  const bool has_fluid = substep.particles.has_fluid();
  const bool shares_nodes = pressure_grid_ && substep.ghosts.exchange;
  if ((!has_fluid && !shares_nodes) || !any_fluid_) return;
  if (pressure_grid_ && iteration == 0) {
    pressure_grid_->displace(substep, parameters_.compressibility, multiplier_.current.view(), allowed_);
  }
  if (!has_fluid) return;
  const pbd::IterationWeights weights = parameters_.chebyshev ? chebyshev_.next(iteration, substep.iterations)
                                                              : pbd::IterationWeights{0, relaxation_};
  const bool last = iteration + 1 == substep.iterations;
  // With a stop, any iteration may turn out to be the last.
  const Recorded recorded = stop_ || (pressure_grid_ && last) ? Recorded::last_error
                            : last && iteration > 0           ? Recorded::decrease
                                                              : Recorded::error_at_start;
  const Advancing advancing{
      .position = substep.particles.position,
      .multiplier = multiplier_.current.view(),
      .increment = increment_.view(),
      .staged = staged_.view(),
      .momentum = weights.momentum,
      .step = weights.step,
      .compliance = parameters_.compressibility / (kernel_.particle_volume * substep.dt * substep.dt),
      .limit = parameters_.correction_limit,
      .first = iteration == 0,
      .fraction = warm_start_fraction_,
      .phase = substep.particles.phase,
      .recorded = recorded,
      .allowed = allowed_};
  const ArtificialPressure& artificial = parameters_.artificial_pressure;
  PairPressure pair;
  if (iteration == 0 && artificial.pressure > 0) {
    const float t = artificial.distance * artificial.distance;
    const float weight = with_shape(kernel_, [&](const auto& kernel) { return kernel.weight_shape(t); });
    pair = {artificial.pressure * kernel_.particle_volume * substep.dt * substep.dt, 1 / weight,
            artificial.exponent};
  }
  refresh_ghost_positions(device_, substep.ghosts, substep.particles.position);
  const bool is_over = stop_ && stop_->is_over();
  if (!is_over) with_shape(kernel_, [&](const auto& kernel) { iterate(kernel, substep, advancing, pair); });
  if (stop_ && last)
    stop_->finish(substep, multiplier_.current.view(), increment_.view(),
                  pressure_grid_ || iteration == 0 ? Recorded::last_error : Recorded::decrease);
  if (pressure_grid_ && last)
    device_.parallel_for("density/pressure", substep.particles.sorted,
                         AddPressure{pressure_grid_->multipliers(), multiplier_.current.view()});
}

template <class D>
void DensitySet<D>::end(pbd::Substep<D>& substep) {
  if (by_baseline_) baseline_->end(substep, multiplier_.current.view());
}

/// Chooses the kernels for what is there. Those of other shapes than the default allow for everything, as
/// each choice costs the time of a compilation.
template <class D>
template <class K>
void DensitySet<D>::iterate(const K& kernel, pbd::Substep<D>& substep,
                            const density_kernels::Advancing& advancing,
                            const density_kernels::PairPressure& pair) {
  using namespace density_kernels;
  const bool moves = substep.contacts.any_moving;
  if constexpr (!std::is_same_v<K, ShapedKernel<SmoothingKernel::poly6_spiky>>)
    iterate<WallMotion::any, Grains::present>(kernel, substep, advancing, pair);
  else if (any_grains_)
    moves ? iterate<WallMotion::any, Grains::present>(kernel, substep, advancing, pair)
          : iterate<WallMotion::none, Grains::present>(kernel, substep, advancing, pair);
  else
    moves ? iterate<WallMotion::any, Grains::absent>(kernel, substep, advancing, pair)
          : iterate<WallMotion::none, Grains::absent>(kernel, substep, advancing, pair);
}

template <class D>
template <density_kernels::WallMotion motion, density_kernels::Grains grains, class K>
void DensitySet<D>::iterate(const K& kernel, pbd::Substep<D>& substep,
                            const density_kernels::Advancing& advancing,
                            const density_kernels::PairPressure& pair) {
  using namespace density_kernels;
  const uint32_t fluid = substep.particles.sorted;
  const pbd::ContactView contacts = substep.contacts.of_first(fluid);
  launch_both("density/multipliers", fluid,
              Advance<K, grains>{kernel, substep.neighbours, contacts.start, advancing},
              contacts.contacts.count,
              AdvanceAtWalls<K, motion, grains>{kernel, substep.neighbours, contacts, advancing});
  if (extrapolates_) {
    if (substep.ghosts.exchange) refresh_ghost_positions(device_, substep.ghosts, staged_.view());
    device_.parallel_for(
        "density/pistons", fluid,
        ExtrapolateToPistons<K>{kernel, substep.neighbours, substep.particles.phase, staged_.view(),
                                multiplier_.current.view(), advancing.first});
  }
  refresh_ghost_positions(device_, substep.ghosts, staged_.view());
  // The first iteration applies the initial multipliers, so it always runs.
  if (stop_) {
    if (advancing.first) stop_->start_substep(substep, multiplier_.current.view());
    stop_->test_convergence(substep, multiplier_.current.view(), parameters_.tolerance,
                            pressure_grid_ || !advancing.first);
  }
  pair.multiplier > 0 ? correct<Repulsion::on, motion>(kernel, substep, pair)
                      : correct<Repulsion::off, motion>(kernel, substep, pair);
}

template <class D>
template <density_kernels::Repulsion repulsion, density_kernels::WallMotion motion, class K>
void DensitySet<D>::correct(const K& kernel, pbd::Substep<D>& substep,
                            const density_kernels::PairPressure& pair) {
  using namespace density_kernels;
  const pbd::ParticleView& p = substep.particles;
  const pbd::ContactView contacts = substep.contacts.of_first(p.sorted);
  pbd::ContactProjection walls = pbd::contact_projection(substep);
  walls.contacts = contacts;
  // True if nothing else moves fluid within an iteration, and every iteration applies all corrections.
  const bool projects = p.owned == p.sorted && !any_grains_ && !stop_;
  launch_both("density/correct", p.sorted,
              Correct<K, repulsion>{kernel, pair, staged_.view(), substep.neighbours, contacts.start,
                                    p.position, p.accumulated_delta},
              contacts.contacts.count,
              CorrectAtWalls<K, repulsion, motion>{kernel, pair, staged_.view(), substep.neighbours, walls,
                                                   projects});
  substep.are_contacts_projected = projects;
}

template <class D>
template <class Run, class LongRun>
void DensitySet<D>::launch_both(const char* name, uint32_t count, const Run& kernel, uint32_t long_count,
                                const LongRun& long_kernel) {
  if (stop_) {
    device_.parallel_for_both(name, count, stop_->unless_ended(kernel), long_count,
                              stop_->unless_ended(long_kernel));
  } else {
    device_.parallel_for_both(name, count, kernel, long_count, long_kernel);
  }
}

template <class D>
void DensitySet<D>::measure(const pbd::Substep<D>& substep, pbd::View<float> error,
                            pbd::View<float> full) const {
  with_shape(kernel_, [&]<class K>(const K& kernel) {
    device_.parallel_for_long(
        "density/measure", substep.particles.sorted,
        density_kernels::Measure<K>{kernel, substep.particles.position, substep.neighbours, substep.contacts,
                                    substep.particles.slot, substep.particles.phase, error, full});
  });
}

// ---- arrays that follow the particles ----

template <class D>
void DensitySet<D>::reserve(uint32_t capacity, uint32_t kept) {
  const uint32_t size = capacity + pbd::Particles::padding;
  multiplier_.reserve(size, kept);
  increment_.resize_discard(size);
  staged_.resize_discard(size);
  // A substep without room for all contacts leaves some unwritten, and is done again.
  increment_.fill(0);
  staged_.fill(0);
  if (pressure_grid_) pressure_grid_->reserve(size);
  if (stop_) stop_->reserve(size);
  if (baseline_) baseline_->reserve(size, capacity);
  crowd_->reserve(size, kept);
  saved_multiplier_.resize_discard(size);
  constexpr float away = pbd::Particles::far_away;
  const pbd::Vec4 sentinel[] = {{away, away, away, 0}};
  staged_.write(sentinel, capacity);
}

template <class D>
void DensitySet<D>::clear(uint32_t first, uint32_t count) {
  crowd_->clear(first, count);
  forget(first, count);
}

/// The next substep of these particles does not start from a multiplier. The pressure grid removes their
/// present error at a rate, as an old one.
template <class D>
void DensitySet<D>::forget(uint32_t first, uint32_t count) {
  device_.parallel_for(
      "density/forget", count,
      density_kernels::ForgetMultipliers{multiplier_.current.view().from(first),
                                         pressure_grid_ ? density_kernels::unmeasured : 0.0f});
}

template <class D>
void DensitySet<D>::reorder(pbd::View<const uint32_t> order, uint32_t count) {
  pbd::gather_in_order(device_, "density/reorder", multiplier_, order, count);
  crowd_->reorder(order, count);
  if (saving_) multiplier_.next.swap(saved_multiplier_);
  saving_ = false;
}

template <class D>
void DensitySet<D>::keep_world(uint32_t each) {
  kept_multiplier_.resize_discard(each);
  device_.copy(kept_multiplier_.view().data, multiplier_.current.view().data,
               each * sizeof(density_kernels::Multiplier));
}

template <class D>
void DensitySet<D>::reset_worlds(const pbd::ChosenWorlds& worlds) {
  pbd::write_worlds(device_, "density/reset", worlds,
                    pbd::View<const density_kernels::Multiplier>(kept_multiplier_.view()),
                    multiplier_.current.view(), pbd::WorldsFrom::one);
}

template <class D>
void DensitySet<D>::undo_worlds(const pbd::ChosenWorlds& worlds) {
  pbd::write_worlds(device_, "density/undo", worlds,
                    pbd::View<const density_kernels::Multiplier>(saved_multiplier_.view()),
                    multiplier_.current.view(), pbd::WorldsFrom::all);
}

template <class D>
bool DensitySet<D>::any_crowd() const {
  return crowd_->any();
}

template <class D>
void DensitySet<D>::set_multipliers(uint32_t first,
                                    std::span<const density_kernels::Multiplier> multipliers) {
  multiplier_.current.write(multipliers, first);
}

/// A part of the state: that of so many particles.
template <class D>
void DensitySet<D>::visit_multipliers(pbd::StateVisitor& v, uint32_t count) {
  v.value("last_dt", last_dt_);
  v.array("multiplier", multiplier_.current.view().first(count), count);
}

template <class D>
void DensitySet<D>::visit_state(pbd::StateVisitor& v) {
  v.value("last_dt", last_dt_);
  v.array("multiplier", multiplier_.current.view(), multiplier_.current.size());
  v.part("crowd", *crowd_);
}

/// Nothing is copied: the next sort keeps the memory with the present values, and uses other memory from then
/// on.
template <class D>
void DensitySet<D>::save() {
  saved_dt_ = last_dt_;
  crowd_->save();
  saving_ = true;
}

template <class D>
void DensitySet<D>::restore() {
  last_dt_ = saved_dt_;
  crowd_->restore();
  if (!saving_) multiplier_.current.swap(saved_multiplier_);
  saving_ = false;
}

}  // namespace meniscus::fluid
