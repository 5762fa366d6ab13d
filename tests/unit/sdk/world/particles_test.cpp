// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Adding and removing particles while the world runs: their ids stay valid.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;

class ParticlesTest : public OnDevice {
 protected:
  WorldDef def_ = world_def(GetParam(), s);

  static std::vector<ParticleId> ids(const World& world) { return {world.ids().begin(), world.ids().end()}; }

  /// Far enough apart that nothing acts on them but gravity, which here is none.
  static std::vector<Vec3> apart(int count, float x = 0) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.push_back({x, float(i), 0});
    return points;
  }
};

TEST_P(ParticlesTest, IdsCountFromZeroAndFollowTheOrderOfMaking) {
  World world(def_);
  const FluidId water = world.create_fluid({});
  EXPECT_EQ(world.add_particles(water, apart(3)), 0u);
  EXPECT_EQ(world.add_fluid(block(water, {5, 5, 5}, {5.1f, 5.1f, 5.1f})), 8u);
  EXPECT_EQ(world.add_particles(water, apart(2, 9)), 11u);
  std::vector<ParticleId> expected(13);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(ids(world), expected);
  EXPECT_EQ(world.particle_count(), 13u);
}

TEST_P(ParticlesTest, HeldReadOutsStayAsTheyAre) {
  std::shared_ptr<const void> positions, velocities;
  std::span<const Vec3> held, held_velocities;
  std::vector<Vec3> before;
  {
    World world(def_);
    const FluidId water = world.create_fluid({});
    world.add_particles(water, apart(5));
    held = world.positions(), held_velocities = world.velocities();
    positions = world.hold(held.data()), velocities = world.hold(held_velocities.data());
    before.assign(held.begin(), held.end());
    world.step(0.01f);
    EXPECT_NE(world.positions().data(), held.data());
    EXPECT_LT(world.positions()[0].y, before[0].y);
    world.add_particles(water, apart(3, 5));
    EXPECT_THROW(world.hold(held.data()), Error) << "it is no longer the world's";
    EXPECT_THROW(world.hold(nullptr), Error);
  }
  for (size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(length(held[i] - before[i]), 0);
    EXPECT_EQ(length(held_velocities[i]), 0);
  }
}

TEST_P(ParticlesTest, HeldReadOutsOfAFarWorldStayToo) {
  def_.origin = {10000, 0, 0};
  World world(def_);
  std::vector<Vec3> points = apart(5);
  for (Vec3& p : points) p.x += 10000;
  world.add_particles(world.create_fluid({}), points);
  const std::span<const Vec3> held = world.positions();
  const std::shared_ptr<const void> kept = world.hold(held.data());
  world.step(0.01f);
  EXPECT_LT(world.positions()[0].y, points[0].y);
  EXPECT_EQ(length(held[0] - points[0]), 0);
}

TEST_P(ParticlesTest, ReleasedReadOutsAreWrittenAgain) {
  World world(def_);
  world.add_particles(world.create_fluid({}), apart(5));
  const Vec3* const first = world.positions().data();
  world.hold(first).reset();
  world.step(0.01f);
  EXPECT_EQ(world.positions().data(), first);
}

TEST_P(ParticlesTest, ReadOutsKeepTheOrderOfIdsThroughSteps) {
  def_.gravity = {0, 0, 0};
  World world(def_);
  const FluidId water = world.create_fluid({}), oil = world.create_fluid({});
  std::mt19937 random(2);
  std::vector<Vec3> start, velocity;
  for (int i = 0; i < 500; ++i) {
    start.push_back({float(i % 10), float(i / 10 % 10), float(i / 100)});
    velocity.push_back(random_vector(random, 0.2f));
  }
  std::shuffle(start.begin(), start.end(), random);
  world.add_particles(water, std::span(start).first(250), std::span(velocity).first(250));
  world.add_particles(oil, std::span(start).last(250), std::span(velocity).last(250));
  run(world, 20, 0.01f);
  for (size_t i = 0; i < 500; ++i) {
    EXPECT_LT(length(world.positions()[i] - (start[i] + 0.2f * velocity[i])), 1e-4f);
    EXPECT_LT(length(world.velocities()[i] - velocity[i]), 1e-3f);
    EXPECT_EQ(world.fluids()[i], i < 250 ? water.index : oil.index);
  }
}

TEST_P(ParticlesTest, RemovalClosesUpAndKeepsTheRest) {
  World world = dam_break(GetParam());
  run(world, 5, 0.016f);
  std::map<ParticleId, Vec3> before;
  for (size_t i = 0; i < world.particle_count(); ++i) before[world.ids()[i]] = world.positions()[i];
  std::vector<ParticleId> gone;
  for (ParticleId id = 0; id < before.size(); id += 3) gone.push_back(id);
  std::reverse(gone.begin(), gone.end());
  gone.push_back(gone.front());  // twice is once
  world.remove_particles(gone);
  for (ParticleId id : gone) before.erase(id);
  ASSERT_EQ(world.particle_count(), before.size());
  size_t i = 0;
  for (const auto& [id, position] : before) {
    EXPECT_EQ(world.ids()[i], id);
    EXPECT_EQ(world.positions()[i], position);
    ++i;
  }
  run(world, 5, 0.016f);
  EXPECT_TRUE(std::is_sorted(world.ids().begin(), world.ids().end()));
  EXPECT_EQ(world.diagnostics().outside, 0u);
}

TEST_P(ParticlesTest, WithoutAnyNothingIsMeasured) {
  World world = dam_break(def_);
  world.step(0.01f);
  EXPECT_GT(world.diagnostics().neighbours_mean, 0);
  world.remove_particles(ids(world));
  EXPECT_EQ(world.diagnostics().neighbours_mean, 0);
  EXPECT_EQ(world.diagnostics().contacts, 0u);
}

TEST_P(ParticlesTest, ErrorsOfDensityAreMeasuredAnewWithoutTheClothThatWasThere) {
  World world(def_);
  world.add_particles(world.create_fluid({}), lattice(8, 4, 8, s, {-0.2f, 0.01f, -0.2f}));
  const auto errors = [&] {
    return std::vector<float>(world.density_errors().begin(), world.density_errors().end());
  };
  const std::vector<float> before = errors();
  ClothDef def;
  def.geometry = SheetGeometry{1, 1, 11, 11};
  const ClothId cloth = world.create_cloth(def);
  const std::vector<float> above_cloth = errors();
  EXPECT_NE(above_cloth, before);
  world.destroy_cloth(cloth);
  EXPECT_EQ(errors(), before);
}

/// In a corner of a tank, and near a fourth wall.
TEST_P(ParticlesTest, WallsThatAreNotMirroredAreCounted) {
  for (const bool fourth : {false, true}) {
    World world(def_);
    world.create_shape(tank({0, 0, 0}, {1, 1, 1}));
    if (fourth) world.create_shape(shape(BoxGeometry{{0.5f, 0.5f, 0.5f}}, {0.5f + 1.3f * s, 0.5f, 0.5f}));
    const Vec3 corner[] = {{0.5f * s, 0.5f * s, 0.5f * s}};
    world.add_particles(world.create_fluid({}), corner);
    EXPECT_EQ(world.diagnostics().wall_overflows, fourth ? 1u : 0u);
  }
}

TEST_P(ParticlesTest, AnIdIsNeverUsedAgain) {
  World world(def_);
  const FluidId water = world.create_fluid({});
  world.add_particles(water, apart(4));
  world.remove_particles(ids(world));
  EXPECT_EQ(world.particle_count(), 0u);
  EXPECT_EQ(world.add_particles(water, apart(2)), 4u);
  EXPECT_EQ(ids(world), (std::vector<ParticleId>{4, 5}));
}

TEST_P(ParticlesTest, TheWorldGrowsWhileItRuns) {
  World world(world_def(GetParam(), 0.1f));
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {1, 2, 1}));
  for (int k = 0; k < 25; ++k) {
    world.add_particles(water, lattice(6, 1, 6, 0.1f, {0.2f, 1.8f, 0.2f}));
    run(world, 6, 0.016f);
  }
  EXPECT_EQ(world.particle_count(), 900u);
  EXPECT_EQ(world.diagnostics().non_finite, 0u);
  EXPECT_EQ(world.diagnostics().outside, 0u);
}

TEST_P(ParticlesTest, AddFluidLeavesOutWhatIsTakenAndWhatIsSolid) {
  World world(def_);
  const FluidId water = world.create_fluid({});
  world.create_shape(shape(SphereGeometry{0.25f}));
  const size_t made = world.add_fluid(block(water, {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}));
  EXPECT_LT(made, 8000u - 500);
  for (Vec3 p : world.positions()) EXPECT_GT(length(p), 0.25f + 0.48f * s);
  EXPECT_EQ(world.add_fluid(block(water, {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f})), 0u);
  EXPECT_EQ(world.particle_count(), made);
}

TEST_P(ParticlesTest, AFilledBallHasTheVolumeOfTheBall) {
  World world(def_);
  FluidVolumeDef ball;
  ball.fluid = world.create_fluid({});
  ball.region = BallRegion{0.5f};
  ball.pose.position = {3, 2, 1};
  ball.velocity = {1, 2, 3};
  const double expected = 4.0 / 3 * 3.14159265 * 0.125 / (double{s} * s * s);
  EXPECT_NEAR(static_cast<double>(world.add_fluid(ball)) / expected, 1, 0.02);
  for (Vec3 v : world.velocities()) EXPECT_EQ(v, (Vec3{1, 2, 3}));
  for (Vec3 p : world.positions()) EXPECT_LT(length(p - Vec3{3, 2, 1}), 0.5f);
}

TEST_P(ParticlesTest, AParticleWeighsItsShareOfTheFluid) {
  World world(def_);
  FluidDef oil;
  oil.rest_density = 800;
  EXPECT_NEAR(world.particle_mass(world.create_fluid(oil)), 800 * s * s * s, 1e-6);
}

MENISCUS_ON_EACH_DEVICE(ParticlesTest);

}  // namespace
}  // namespace meniscus::tests
