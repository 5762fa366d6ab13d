// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The steps of the baselines: their lengths, their iterations, and that they can be repeated.
#include <gtest/gtest.h>

#include "fluid/baselines/tuning.h"
#include "tests/many_threads.h"
#include "tests/unit/fluid/baselines/baseline_worlds.h"

namespace meniscus::tests {
namespace {

using namespace fluid::baseline_tuning;

class BaselineStepTest : public OnDevice {
 protected:
  WorldDef def(DensitySolver solver) const { return baseline_def(GetParam(), solver); }

  uint64_t hash_after_a_splash(DensitySolver solver, int threads) const {
    WorldDef d = def(solver);
    d.threads = threads;
    Pool pool(d, 0.3f, 0.4f);
    BodyDef box;
    box.geometry = BoxGeometry{{0.1f, 0.1f, 0.1f}};
    box.pose.position = {0.2f, 0.5f, 0.2f};
    pool.world.create_body(box);
    run(pool.world, 20, baseline_frame);
    return pool.world.state_hash();
  }
};

TEST_P(BaselineStepTest, TheFastestParticleBoundsTheSubstep) {
  for (DensitySolver solver : {DensitySolver::pcisph, DensitySolver::dfsph}) {
    WorldDef d = def(solver);
    d.gravity = {0, 0, 0};
    World world(d);
    const FluidId water = world.create_fluid({});
    world.add_particles(water, lattice(4, 4, 4, baseline_spacing, {0, 0, 0}));
    EXPECT_EQ(world.step(baseline_frame).substeps, d.substeps) << name_of(solver);
    constexpr float speed = 15;
    add_moving(world, water, {{5, 5, 5}}, {speed, 0, 0});
    const float wanted = speed * baseline_frame / (d.density.courant_number * baseline_spacing);
    EXPECT_EQ(world.step(baseline_frame).substeps, int(std::ceil(wanted))) << name_of(solver);
    d.density.courant_number = 0;
    world.set_def(d);
    EXPECT_EQ(world.step(baseline_frame).substeps, d.substeps) << name_of(solver);
  }
}

TEST_P(BaselineStepTest, SoundBoundsTheSubstep) {
  WorldDef d = def(DensitySolver::wcsph);
  d.density.compressibility = 1e-6f;
  const auto substeps = [&](float compressibility) {
    d.density.compressibility = compressibility;
    World world(d);
    world.add_particles(world.create_fluid({}), lattice(4, 4, 4, baseline_spacing, {0, 0, 0}));
    return float(world.step(baseline_frame).substeps);
  };
  const float sound = std::sqrt(1 / (1e-6f * 1000));  // m/s
  const float wanted =
      baseline_frame * sound * (1 + 0.6f * artificial_viscosity) / (sound_courant_number * baseline_spacing);
  EXPECT_NEAR(substeps(1e-6f), wanted, 0.02f * wanted + 1);
  EXPECT_NEAR(substeps(2.5e-7f), 2 * wanted, 0.04f * wanted + 1);
}

TEST_P(BaselineStepTest, WcsphKeepsTheDensityWithinOnePercent) {
  Pool pool(def(DensitySolver::wcsph), 0.5f, 0.4f);
  run(pool.world, 60, baseline_frame);
  const Diagnostics found = pool.world.diagnostics();
  EXPECT_LT(found.density_error_max, 0.015);
  EXPECT_GT(found.density_error_mean, 1e-4);
}

TEST_P(BaselineStepTest, IterationsEndAtTheTolerance) {
  WorldDef d = def(DensitySolver::pcisph);
  d.iterations = 60;
  {
    Pool pool(d, 0.5f, 0.4f);
    run(pool.world, 30, baseline_frame);
    const StepReport report = pool.world.step(baseline_frame);
    EXPECT_GE(report.density_iterations, least_pcisph_iterations);
    EXPECT_LT(report.density_iterations, 30);
    EXPECT_LT(pool.world.diagnostics().density_error_max, 1.2 * double{pcisph_tolerance});
  }
  d.density.solver = DensitySolver::dfsph;
  d.iterations = 200;
  for (float tolerance : {0.0f, 1e-3f}) {
    d.density.tolerance = tolerance;
    Pool pool(d, 0.5f, 0.4f);
    run(pool.world, 30, baseline_frame);
    const StepReport report = pool.world.step(baseline_frame);
    EXPECT_GE(report.density_iterations, least_dfsph_iterations + least_divergence_iterations);
    EXPECT_LT(report.density_iterations, 200);
    const double wanted = tolerance > 0 ? double{tolerance} : double{dfsph_tolerance};
    EXPECT_LT(pool.world.diagnostics().density_error_mean, 1.1 * wanted);
    EXPECT_GT(pool.world.diagnostics().density_error_mean, 0.1 * wanted);
  }
}

TEST_P(BaselineStepTest, TheResultDoesNotDependOnThreads) {
  const ManyThreads many;
  for (DensitySolver solver : all_baselines) {
    const uint64_t once = hash_after_a_splash(solver, 1);
    EXPECT_EQ(hash_after_a_splash(solver, 1), once) << name_of(solver);
    EXPECT_EQ(hash_after_a_splash(solver, 4), once) << name_of(solver);
  }
}

TEST_P(BaselineStepTest, AWorldMayChangeItsSolver) {
  WorldDef d = def(DensitySolver::chebyshev);
  Pool pool(d, 0.3f, 0.4f);
  for (DensitySolver solver :
       {DensitySolver::pcisph, DensitySolver::dfsph, DensitySolver::wcsph, DensitySolver::chebyshev}) {
    d.density.solver = solver;
    pool.world.set_def(d);
    run(pool.world, 30, baseline_frame);
    const Diagnostics found = pool.world.diagnostics();
    EXPECT_LT(found.max_speed, 1.5) << static_cast<int>(solver);
    EXPECT_LT(found.density_error_mean, 0.01) << static_cast<int>(solver);
  }
}

// Overlaps are relaxed by the density constraint, whatever the solver.
TEST_P(BaselineStepTest, OverlapsAreRelaxed) {
  for (DensitySolver solver : all_baselines) {
    World world(def(solver));
    world.create_shape(tank({0, 0, 0}, {0.4f, 1, 0.4f}));
    world.add_particles(world.create_fluid({}), lattice(10, 10, 10, 0.8f * baseline_spacing, {0, 0, 0}));
    const double before = world.diagnostics().density_error_mean;
    world.relax(50);
    EXPECT_LT(world.diagnostics().density_error_mean, 0.3 * before) << name_of(solver);
  }
}

MENISCUS_ON_EACH_DEVICE(BaselineStepTest);

}  // namespace
}  // namespace meniscus::tests
