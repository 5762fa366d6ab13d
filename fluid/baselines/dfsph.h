// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Divergence-free SPH.
#pragma once

#include "fluid/baselines/convergence_kernels.h"
#include "fluid/baselines/dfsph_kernels.h"
#include "fluid/baselines/fluid_motion.h"
#include "fluid/baselines/pressure_stage.h"
#include "fluid/density/baseline.h"

namespace meniscus::fluid {

/// DFSPH (Bender & Koschier 2015) has two solvers, each a Jacobi iteration with ω = ½ and a warm start:
///
///   density      C_i = 0 at the predicted positions,        Λ_i' = max(0, Λ_i + ω C_i/D_i)
///   divergence   dC_i/dt = 0 with the velocities at the substep's end, likewise with h_t dC_i/dt for C_i
///
/// D is that of the density constraint, which is their 1/α. Gradients are those at the start of each solver.
/// The iterations end when the mean of max(C, 0) is at most 0.01 %, or a given tolerance, and the mean of
/// max(h_t dC/dt, 0) at most 0.1 %.
template <class D>
class Dfsph final : public Baseline<D> {
 public:
  using typename Baseline<D>::Multipliers;

  Dfsph(D& device, const Kernel& kernel, const DensityParameters& parameters)
      : device_(device),
        stage_(device, kernel),
        density_end_(device),
        divergence_end_(device),
        motion_(device),
        parameters_(parameters) {}

  void set_parameters(const DensityParameters& parameters) override { parameters_ = parameters; }
  void reserve(uint32_t size, uint32_t sentinel) override { stage_.reserve(size, sentinel); }
  void start_step() override {
    density_end_.start_step();
    divergence_end_.start_step();
  }
  int least_substeps(float dt, int chosen, const pbd::ParticleView& start) override {
    return courant_substeps(motion_.read(start, parameters_.gravity), dt, parameters_, chosen);
  }
  uint32_t iterations_done(uint32_t) const override {
    return density_end_.iterations() + divergence_end_.iterations();
  }

  void begin(pbd::Substep<D>& substep, Multipliers multiplier, float scale) override;
  void project(pbd::Substep<D>& substep, Multipliers multiplier, int iteration) override;
  void end(pbd::Substep<D>& substep, Multipliers multiplier) override;

 private:
  void iterate_divergence(pbd::Substep<D>& s, Multipliers multiplier, int iteration);
  static auto always() {
    return [](const auto& kernel) { return kernel; };
  }
  static auto unless_ended(const IterationEnd<D>& end) {
    return [&end](const auto& kernel) { return end.unless_ended(kernel); };
  }

  D& device_;
  PressureStage<D> stage_;
  IterationEnd<D> density_end_, divergence_end_;
  MotionReader<D> motion_;
  DensityParameters parameters_;
};

template <class D>
void Dfsph<D>::begin(pbd::Substep<D>& s, Multipliers multiplier, float scale) {
  stage_.stage(s);
  stage_.find_steps(s, baseline_tuning::dfsph_relaxation);
  device_.parallel_for(
      "baseline/start", s.particles.sorted,
      baseline_kernels::StartDensity{scale, baseline_tuning::dfsph_warm_start, multiplier, stage_.staged()});
  stage_.push(s, stage_.to_positions(s), always());
}

template <class D>
void Dfsph<D>::project(pbd::Substep<D>& s, Multipliers multiplier, int iteration) {
  using namespace baseline_kernels;
  if (!density_end_.is_over()) {
    const auto wrap = unless_ended(density_end_);
    stage_.compress(s, wrap);
    density_end_.test(s.particles.sorted, Excess{stage_.compression(), density_end_.progress()},
                      density_kernels::AddErrors{},
                      parameters_.tolerance > 0 ? parameters_.tolerance : baseline_tuning::dfsph_tolerance,
                      iteration >= baseline_tuning::least_dfsph_iterations);
    device_.parallel_for(
        "baseline/relax", s.particles.sorted,
        wrap(Relax<&Multiplier::value>{stage_.compression(), stage_.step(), multiplier, stage_.staged()}));
    stage_.push(s, stage_.to_positions(s), wrap);
  }
  if (iteration + 1 == s.iterations) density_end_.finish();
}

template <class D>
void Dfsph<D>::end(pbd::Substep<D>& s, Multipliers multiplier) {
  using namespace baseline_kernels;
  stage_.stage(s);
  stage_.find_steps(s, baseline_tuning::dfsph_relaxation);
  device_.parallel_for("baseline/start", s.particles.sorted, StartDivergence{multiplier, stage_.staged()});
  stage_.push(s, stage_.template to_velocities<true>(s), always());
  for (int k = 0; k < s.iterations && !divergence_end_.is_over(); ++k) iterate_divergence(s, multiplier, k);
  divergence_end_.finish();
  device_.parallel_for("baseline/add", s.particles.sorted, AddDivergence{multiplier});
}

template <class D>
void Dfsph<D>::iterate_divergence(pbd::Substep<D>& s, Multipliers multiplier, int iteration) {
  using namespace baseline_kernels;
  const auto wrap = unless_ended(divergence_end_);
  const pbd::ParticleView& p = s.particles;
  const pbd::ContactView contacts = s.contacts.of_first(p.sorted);
  const Divergence open{stage_.kernel(), p.position, p.velocity,          s.neighbours,
                        contacts.start,  s.dt,       stage_.compression()};
  device_.parallel_for_both("baseline/divergence", p.sorted, wrap(open), contacts.contacts.count,
                            wrap(DivergenceAtWalls{open, contacts}));
  divergence_end_.test(p.sorted, Excess{stage_.compression(), divergence_end_.progress()},
                       density_kernels::AddErrors{}, baseline_tuning::divergence_tolerance,
                       iteration >= baseline_tuning::least_divergence_iterations);
  device_.parallel_for(
      "baseline/relax", p.sorted,
      wrap(Relax<&Multiplier::relieved>{stage_.compression(), stage_.step(), multiplier, stage_.staged()}));
  stage_.push(s, stage_.template to_velocities<true>(s), wrap);
}

}  // namespace meniscus::fluid
