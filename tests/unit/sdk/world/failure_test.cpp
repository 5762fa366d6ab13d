// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A step that meets values that are not finite reports them, and leaves the state as it was.
#include <gtest/gtest.h>

#include "tests/expect_error.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class FailureTest : public OnDevice {
 protected:
  World world_ = dam_break(GetParam(), 0.1f);
  FluidId water_ = world_.create_fluid({});

  ParticleId add_mad_particle(Vec3 velocity) {
    const std::vector<Vec3> position{{0.8f, 0.5f, 0.25f}}, velocities{velocity};
    return world_.add_particles(water_, position, velocities);
  }
};

TEST_P(FailureTest, AnAbsurdVelocityStopsTheStepAndNothingHasHappened) {
  run(world_, 5, 0.016f);
  const ParticleId mad = add_mad_particle({3e38f, 3e38f, 3e38f});
  const uint64_t hash = world_.state_hash();
  const double time = world_.time();
  const std::vector<Vec3> positions(world_.positions().begin(), world_.positions().end());
  expect_error(ErrorCode::non_finite, std::to_string(mad), [&] { world_.step(1000); });
  EXPECT_EQ(world_.state_hash(), hash);
  EXPECT_EQ(world_.time(), time);
  for (size_t i = 0; i < positions.size(); ++i) EXPECT_EQ(world_.positions()[i], positions[i]);
}

TEST_P(FailureTest, WithoutTheCulpritTheWorldGoesOn) {
  const std::vector<ParticleId> mad{add_mad_particle({-3e38f, 0, 0})};
  expect_error(ErrorCode::non_finite, "non-finite", [&] { world_.step(1000); });
  expect_error(ErrorCode::non_finite, "non-finite", [&] { world_.step(1000); });
  world_.remove_particles(mad);
  run(world_, 20, 0.016f);
  EXPECT_EQ(world_.diagnostics().non_finite, 0u);
  EXPECT_EQ(world_.diagnostics().outside, 0u);
}

TEST_P(FailureTest, AFailedStepLeavesNoTraceInWhatFollows) {
  World twin = dam_break(GetParam(), 0.1f);
  run(world_, 10, 0.016f);
  run(twin, 10, 0.016f);
  expect_error(ErrorCode::non_finite, "non-finite", [&] { world_.step(1e20f); });
  EXPECT_EQ(world_.state_hash(), twin.state_hash());
  run(world_, 10, 0.016f);
  run(twin, 10, 0.016f);
  EXPECT_EQ(world_.state_hash(), twin.state_hash());
}

TEST_P(FailureTest, AFailedStepTakesNothingToTheSink) {
  world_.create_sink({"", BoxRegion{{-9, -9, -9}, {9, 9, 9}}, false, {}, {}});
  add_mad_particle({0, 3e38f, 0});
  const size_t count = world_.particle_count();
  expect_error(ErrorCode::non_finite, "non-finite", [&] { world_.step(1000); });
  EXPECT_EQ(world_.particle_count(), count);
}

TEST_P(FailureTest, AVeryFastParticleThatStaysFiniteIsNoFailure) {
  add_mad_particle({0, 1e15f, 0});
  run(world_, 3, 0.016f);
  EXPECT_EQ(world_.diagnostics().non_finite, 0u);
}

// Where a step goes wrong for speed alone, the choice of substeps must cope with it as well.
TEST_P(FailureTest, AnAbsurdVelocityWithAdaptiveSubsteps) {
  WorldDef def = world_def(GetParam(), 0.1f);
  def.cfl_number = 0.4f;
  World world(def);
  const std::vector<Vec3> position{{0, 0, 0}}, velocity{{1e38f, 1e38f, 1e38f}};
  world.add_particles(world.create_fluid({}), position, velocity);
  const uint64_t hash = world.state_hash();
  try {
    EXPECT_LE(world.step(1000).substeps, def.max_substeps);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::non_finite);
    EXPECT_EQ(world.state_hash(), hash);
  }
}

MENISCUS_ON_EACH_DEVICE(FailureTest);

}  // namespace
}  // namespace meniscus::tests
