// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Predictive-corrective incompressible SPH.
#pragma once

#include "fluid/baselines/convergence_kernels.h"
#include "fluid/baselines/fluid_motion.h"
#include "fluid/baselines/pressure_stage.h"
#include "fluid/density/baseline.h"

namespace meniscus::fluid {

/// PCISPH (Solenthaler & Pajarola 2009). In each substep Λ = V h_t² p starts from 0, and an iteration adds
///
///   Λ_i' = max(0, Λ_i + δ C_i),   δ = m / (2 Σ |e|²)  over the rest lattice (their eq. 8)
///
/// where C_i is that of the predicted position. Gradients stay those of the first prediction. The iterations
/// end when no C exceeds 1 %, or the mean of max(C, 0) a given tolerance.
///
/// Of several fluids m is the smallest mass of a particle: with its own, a heavy particle among light ones
/// would overshoot.
///
/// Where a body that can move is near, δ is that of the particle's own D if that is smaller: the body's
/// inverse mass counts.
template <class D>
class Pcisph final : public Baseline<D> {
 public:
  using typename Baseline<D>::Multipliers;

  Pcisph(D& device, const Kernel& kernel, const DensityParameters& parameters)
      : device_(device), stage_(device, kernel), end_(device), motion_(device), parameters_(parameters) {}

  void set_parameters(const DensityParameters& parameters) override { parameters_ = parameters; }
  void reserve(uint32_t size, uint32_t sentinel) override { stage_.reserve(size, sentinel); }
  void start_step() override { end_.start_step(); }
  int least_substeps(float dt, int chosen, const pbd::ParticleView& start) override {
    const FluidMotion motion = motion_.read(start, parameters_.gravity);
    prototype_step_ = 0.5f / (motion.inverse_mass * stage_.kernel().rest_gradient2);
    return courant_substeps(motion, dt, parameters_, chosen);
  }
  uint32_t iterations_done(uint32_t) const override { return end_.iterations(); }

  void begin(pbd::Substep<D>& substep, Multipliers multiplier, float) override;
  void project(pbd::Substep<D>& substep, Multipliers multiplier, int iteration) override;

 private:
  D& device_;
  PressureStage<D> stage_;
  IterationEnd<D> end_;
  MotionReader<D> motion_;
  DensityParameters parameters_;
  float prototype_step_ = 0;  // δ, kg·m²
};

namespace baseline_kernels {

struct StartPcisph {
  float prototype;  ///< δ, kg·m²
  bool has_steps;   ///< 1/(2 D) of each particle is known
  View<const uint32_t> contact_start;
  View<Multiplier> multiplier;
  View<float> step;

  MENISCUS_HD void operator()(uint32_t i) const {
    multiplier[i] = {0, 0};
    const bool at_wall = has_steps && contact_start[i] != contact_start[i + 1];
    step[i] = at_wall ? pbd::min(step[i], prototype) : prototype;
  }
};

}  // namespace baseline_kernels

template <class D>
void Pcisph<D>::begin(pbd::Substep<D>& s, Multipliers multiplier, float) {
  stage_.stage(s);
  const bool has_steps = s.contacts.any_moving;
  if (has_steps) stage_.find_steps(s, 0.5f);
  device_.parallel_for(
      "baseline/start", s.particles.sorted,
      baseline_kernels::StartPcisph{prototype_step_, has_steps, s.contacts.start, multiplier, stage_.step()});
}

template <class D>
void Pcisph<D>::project(pbd::Substep<D>& s, Multipliers multiplier, int iteration) {
  using namespace baseline_kernels;
  const auto unless_ended = [&](const auto& kernel) { return end_.unless_ended(kernel); };
  const uint32_t fluid = s.particles.sorted;
  if (!end_.is_over()) {
    stage_.compress(s, unless_ended);
    const Excess excess{stage_.compression(), end_.progress()};
    const bool may_end = iteration >= baseline_tuning::least_pcisph_iterations;
    if (parameters_.tolerance > 0) {
      end_.test(fluid, excess, density_kernels::AddErrors{}, parameters_.tolerance, may_end);
    } else {
      end_.test(fluid, excess, LargestError{}, baseline_tuning::pcisph_tolerance, may_end);
    }
    device_.parallel_for("baseline/relax", fluid,
                         unless_ended(Relax<&Multiplier::value>{stage_.compression(), stage_.step(),
                                                                multiplier, stage_.staged()}));
    stage_.push(s, stage_.to_positions(s), unless_ended);
  }
  if (iteration + 1 == s.iterations) end_.finish();
}

}  // namespace meniscus::fluid
