// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Weakly compressible SPH.
#pragma once

#include "fluid/baselines/fluid_motion.h"
#include "fluid/baselines/pressure_stage.h"
#include "fluid/baselines/wcsph_kernels.h"
#include "fluid/density/baseline.h"

namespace meniscus::fluid {

/// WCSPH (Becker & Teschner 2007). Forces follow from the positions of the substep's end, x + h_t v + h_t² g:
///
///   p_i = ρ₀ c²/7 ((1 + C_i)⁷ − 1) ≥ 0
///   h_t dv_i/dt = w_i/h_t Σ (Λ_i/(1 + C_i)² + Λ_j/(1 + C_j)²) e_ij + artificial viscosity,  Λ = V h_t² p
///
/// They change velocities alone. With the move of the next substep that is the symplectic Euler rule; the
/// velocities that can be read lack that substep's gravity.
///
/// c is ten times the speed of a particle that falls from the highest energy to the lowest place, so that C
/// stays near 1 %; or it follows from a given bulk modulus. Substeps are h_t ≤ 1.2 s/(c (1 + 0.6 α)) long.
template <class D>
class Wcsph final : public Baseline<D> {
 public:
  using typename Baseline<D>::Multipliers;

  Wcsph(D& device, const Kernel& kernel, const DensityParameters& parameters)
      : device_(device), stage_(device, kernel), motion_(device), parameters_(parameters) {}

  void set_parameters(const DensityParameters& parameters) override { parameters_ = parameters; }
  void reserve(uint32_t size, uint32_t sentinel) override {
    stage_.reserve(size, sentinel);
    change_.resize_discard(size);
    change_.fill(0);
  }
  int least_substeps(float dt, int chosen, const pbd::ParticleView& start) override;
  uint32_t iterations_done(uint32_t) const override { return 0; }

  void begin(pbd::Substep<D>& substep, Multipliers multiplier, float) override;
  void project(pbd::Substep<D>&, Multipliers, int) override {}

 private:
  /// N·m: V times the bulk modulus that is given, or 0.
  float modulus() const {
    return parameters_.compressibility > 0 ? stage_.kernel().particle_volume / parameters_.compressibility
                                           : 0.0f;
  }

  D& device_;
  PressureStage<D> stage_;
  MotionReader<D> motion_;
  DensityParameters parameters_;
  float sound_ = 0;  // m/s, of the step
  pbd::Buffer<pbd::Vec4> change_{device_, "viscous changes"};
};

template <class D>
int Wcsph<D>::least_substeps(float dt, int chosen, const pbd::ParticleView& start) {
  using namespace baseline_tuning;
  const FluidMotion motion = motion_.read(start, parameters_.gravity);
  const float s = parameters_.spacing, rest = std::sqrt(2 * length(parameters_.gravity) * s);
  sound_ = parameters_.compressibility > 0 ? std::sqrt(modulus() * motion.inverse_mass)
                                           : sound_over_speed * std::max(rest, motion.greatest_speed());
  const float longest = sound_courant_number * s / (sound_ * (1 + 0.6f * artificial_viscosity) + 1e-30f);
  return substeps_within(dt, longest, courant_substeps(motion, dt, parameters_, chosen));
}

template <class D>
void Wcsph<D>::begin(pbd::Substep<D>& s, Multipliers multiplier, float) {
  using namespace baseline_kernels;
  const pbd::ParticleView& p = s.particles;
  const BaselineKernel& kernel = stage_.kernel();
  const pbd::ContactView contacts = s.contacts.of_first(p.sorted);
  const float smoothing = 0.5f * kernel.h;  // the smoothing length of a kernel with support h
  const ArtificialViscosity viscosity{
      .kernel = kernel,
      .position = p.position,
      .velocity = p.velocity,
      .scale = 2 * baseline_tuning::artificial_viscosity * smoothing * sound_ * s.dt * kernel.peak_pull,
      .offset = 0.01f * smoothing * smoothing};
  stage_.stage(s);
  device_.parallel_for_both(
      "baseline/sums", p.sorted,
      WcsphSums{viscosity, s.neighbours, contacts.start, stage_.compression(), change_.view()},
      contacts.contacts.count,
      WcsphSumsAtWalls{
          viscosity, {kernel, p.position, s.neighbours, contacts, stage_.compression()}, change_.view()});
  const bool given = parameters_.compressibility > 0;
  device_.parallel_for(
      "baseline/tait", p.sorted,
      ApplyTait{stage_.compression(), change_.view(), p.position, given ? 0.0f : sound_ * sound_, modulus(),
                s.dt * s.dt, multiplier, stage_.staged(), p.velocity});
  stage_.push(s, stage_.template to_velocities<false>(s), [](const auto& launch) { return launch; });
}

}  // namespace meniscus::fluid
