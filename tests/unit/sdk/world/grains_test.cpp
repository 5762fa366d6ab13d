// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Granular materials: contacts, friction and the interaction with fluids.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/expect_error.h"
#include "tests/many_threads.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.02f;

GranularDef sand(float density = 1600, float friction = 0.5f) {
  GranularDef def;
  def.density = density;
  def.friction = friction;
  return def;
}

/// How far the worst pair of grains is inside one another, over their diameter.
float worst_overlap(std::span<const Vec3> points, float diameter) {
  std::vector<Vec3> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(), [](Vec3 a, Vec3 b) { return a.x < b.x; });
  float worst = 0;
  for (size_t i = 0; i < sorted.size(); ++i) {
    for (size_t j = i + 1; j < sorted.size() && sorted[j].x - sorted[i].x < diameter; ++j)
      worst = std::max(worst, 1 - length(sorted[j] - sorted[i]) / diameter);
  }
  return worst;
}

float fastest(const World& world) {
  float speed = 0;
  for (Vec3 v : world.velocities()) speed = std::max(speed, length(v));
  return speed;
}

/// Grains that fall into a box with smooth walls from a loose heap, and come to rest.
World poured(const WorldDef& def, int layers, FluidId* material = nullptr) {
  World world(def);
  const FluidId id = world.create_granular(sand());
  if (material) *material = id;
  world.create_shape(tank({-3.7f * s, 0, -3.7f * s}, {3.7f * s, 100 * s, 3.7f * s}));
  std::mt19937 random(5);
  std::vector<Vec3> points;
  for (Vec3 p : lattice(5, layers, 5, 1.3f * s, {-3.25f * s, 0, -3.25f * s}))
    points.push_back(p + random_vector(random, 0.14f * s));
  world.add_particles(id, points);
  return world;
}

class GrainsTest : public OnDevice {
 protected:
  WorldDef def() const { return world_def(GetParam(), s); }
  WorldDef in_space() const {
    WorldDef d = def();
    d.gravity = {0, 0, 0};
    return d;
  }
};

// Each is split among as many contacts as press on it at once, those that the solve makes included.
TEST_P(GrainsTest, ARowWhoseHalvesMeetDoesNotFlyApart) {
  constexpr float speed = 0.05f;
  for (const int substeps : {4, 40}) {
    for (const float pitch : {1.0f, 1.002f, 1.01f}) {
      SCOPED_TRACE(testing::Message() << substeps << " substeps, a pitch of " << pitch);
      WorldDef d = in_space();
      d.substeps = substeps;
      World world(d);
      std::vector<Vec3> at, v;
      for (int k = 0; k < 8; ++k) {
        at.push_back({pitch * s * float(k), 0, 0});
        v.push_back({k < 4 ? speed : -speed, 0, 0});
      }
      world.add_particles(world.create_granular(sand()), at, v);
      for (int k = 0; k < 60; ++k) {
        world.step(1 / 60.0f);
        ASSERT_LE(fastest(world), 1.01f * speed) << "frame " << k;
      }
    }
  }
}

TEST_P(GrainsTest, AColumnThatLandsInATubeThrowsNoneUp) {
  constexpr float drop = 2 * s;
  World world(def());
  world.create_shape(tank({-1.2f * s, 0, -1.2f * s}, {1.2f * s, 100 * s, 1.2f * s}));
  world.add_particles(world.create_granular(sand()), lattice(2, 20, 2, s, {-s, drop, -s}));
  float most = 0;
  for (int k = 0; k < 60; ++k) {
    world.step(1 / 60.0f);
    most = std::max(most, fastest(world));
    for (Vec3 x : world.positions()) ASSERT_LT(x.y, drop + 20 * s) << "frame " << k;
  }
  EXPECT_LT(most, 1.2f * std::sqrt(2 * 9.81f * drop));
}

TEST_P(GrainsTest, TwoThatMeetShareTheirMomentum) {
  World world(in_space());
  const FluidId light = world.create_granular(sand(500)), heavy = world.create_granular(sand(1500));
  world.add_particles(light, std::vector<Vec3>{{-s, 0, 0}}, std::vector<Vec3>{{1, 0, 0}});
  world.add_particles(heavy, std::vector<Vec3>{{s, 0, 0}}, std::vector<Vec3>{{-1, 0, 0}});
  run(world, 20, 0.005f);
  // Without a bounce they go on together: (0.5 − 1.5)/2 m/s.
  EXPECT_NEAR(world.velocities()[0].x, -0.5f, 0.02f);
  EXPECT_NEAR(world.velocities()[1].x, -0.5f, 0.02f);
  EXPECT_NEAR(length(world.positions()[0] - world.positions()[1]), s, 0.03f * s);
}

TEST_P(GrainsTest, CloudsThatCollideKeepTheirMomentum) {
  World world(in_space());
  const FluidId ids[] = {world.create_granular(sand(800)), world.create_granular(sand(4000, 0.2f))};
  std::mt19937 random(3);
  double before[3] = {0, 0, 0}, magnitude = 0;
  for (int side : {0, 1}) {
    std::vector<Vec3> points, velocities;
    for (Vec3 p : lattice(6, 8, 8, s, {side ? s : -7 * s, -4 * s, -4 * s})) {
      points.push_back(p + random_vector(random, 0.1f * s));
      velocities.push_back(Vec3{side ? -1.0f : 1.0f, 0.2f, 0} + random_vector(random, 0.3f));
      const double m = world.particle_mass(ids[side]);
      before[0] += m * velocities.back().x;
      before[1] += m * velocities.back().y;
      before[2] += m * velocities.back().z;
      magnitude += m * length(velocities.back());
    }
    world.add_particles(ids[side], points, velocities);
  }
  run(world, 60, 0.005f);
  double after[3] = {0, 0, 0}, left = 0;
  for (size_t i = 0; i < world.particle_count(); ++i) {
    const double m = world.particle_mass(ids[world.fluids()[i]]);
    const Vec3 v = world.velocities()[i];
    after[0] += m * v.x;
    after[1] += m * v.y;
    after[2] += m * v.z;
    left += m * length(v);
  }
  for (int k = 0; k < 3; ++k) EXPECT_NEAR((after[k] - before[k]) / magnitude, 0, 1e-5);
  EXPECT_LT(left, 0.8 * magnitude);  // they did meet
}

TEST_P(GrainsTest, RestUnderTwentyLayers) {
  World world = poured(def(), 35);
  run(world, 150, 1.0f / 60);
  EXPECT_LT(worst_overlap(world.positions(), s), 0.05f);
  EXPECT_LT(fastest(world), 0.005f);
  // 875 grains over 7.4² of them, in disorder: at least as dense as the loosest lattice.
  EXPECT_GT(mean_height(world), 6.5f * s);
  EXPECT_LT(mean_height(world), 8.5f * s);
}

TEST_P(GrainsTest, OverlapsComeApartWithoutABlast) {
  World world(in_space());
  const FluidId id = world.create_granular(sand());
  std::mt19937 random(8);
  std::vector<Vec3> points;
  for (Vec3 p : lattice(8, 8, 8, 0.9f * s, {0, 0, 0})) points.push_back(p + random_vector(random, 0.2f * s));
  points.push_back(points.front());  // two on the very same point
  world.add_particles(id, points);
  EXPECT_GT(worst_overlap(points, s), 0.5f);
  float speed = 0;
  for (int k = 0; k < 120; ++k) {
    world.step(1.0f / 60);
    speed = std::max(speed, fastest(world));
  }
  EXPECT_LT(worst_overlap(world.positions(), s), 0.02f);
  EXPECT_LT(speed, 30 * s);  // m/s: an overlap of s is undone at 15 of it a second
}

TEST_P(GrainsTest, ManyAtOnePlaceFindRoom) {
  World world(in_space());
  std::mt19937 random(9);
  std::vector<Vec3> points;
  for (int k = 0; k < 40; ++k) points.push_back(random_vector(random, 0.3f * s));
  world.add_particles(world.create_granular(sand()), points);
  run(world, 60, 1.0f / 60);
  EXPECT_LT(worst_overlap(world.positions(), s), 0.05f);
}

TEST_P(GrainsTest, FrictionHoldsAPileUp) {
  float height[2];
  for (int k : {0, 1}) {
    World world(def());
    const FluidId id = world.create_granular(sand(1600, k ? 0.8f : 0.0f));
    ShapeDef floor = shape(PlaneGeometry{});
    floor.surface.friction = 0.8f;
    world.create_shape(floor);
    world.add_fluid(block(id, {-4 * s, 0, -4 * s}, {4 * s, 10 * s, 4 * s}));
    run(world, 90, 1.0f / 60);
    height[k] = static_cast<float>(mean_height(world));
  }
  EXPECT_GT(height[1], 1.3f * height[0]);
}

TEST_P(GrainsTest, LightOnesFloatAndHeavyOnesSink) {
  for (float ratio : {0.2f, 0.5f, 2.0f, 10.0f}) {
    WorldDef d = world_def(GetParam(), 0.05f);
    World world(d);
    const FluidId water = world.create_fluid({}), grains = world.create_granular(sand(1000 * ratio));
    world.create_shape(tank({0, 0, 0}, {0.3f, 1, 0.3f}));
    world.add_fluid(block(water, {0, 0, 0}, {0.3f, 0.5f, 0.3f}));
    std::vector<ParticleId> ids;
    std::vector<Vec3> points;
    for (size_t i = 0; i < world.particle_count(); ++i) {
      const Vec3 p = world.positions()[i];
      if (std::fabs(p.y - 0.275f) > 0.03f ||
          static_cast<int>(std::floor(p.x / 0.05f) + std::floor(p.z / 0.05f)) % 3)
        continue;
      ids.push_back(world.ids()[i]);
      points.push_back(p);
    }
    world.remove_particles(ids);
    world.add_particles(grains, points);
    run(world, 150, 1.0f / 60);
    double height = 0;
    for (size_t i = 0; i < world.particle_count(); ++i) {
      if (world.fluids()[i] == grains.index) height += world.positions()[i].y;
    }
    height /= static_cast<double>(points.size());
    if (ratio < 1)
      EXPECT_GT(height, 0.40f) << ratio;
    else
      EXPECT_LT(height, 0.12f) << ratio;
  }
}

TEST_P(GrainsTest, FluidAndGrainsKeepTheirMomentum) {
  for (float ratio : {0.2f, 10.0f}) {
    World world(in_space());
    FluidDef water;
    water.dynamic_viscosity = 1;
    const FluidId ids[] = {world.create_fluid(water), world.create_granular(sand(1000 * ratio))};
    std::mt19937 random(4);
    Vec3 before{0, 0, 0};
    double magnitude = 0;
    for (int k : {0, 1}) {
      std::vector<Vec3> points, velocities;
      for (Vec3 p : lattice(6, 6, 6, s, {k ? 0.5f * s : -6.5f * s, -3 * s, -3 * s})) {
        points.push_back(p + random_vector(random, 0.1f * s));
        velocities.push_back(Vec3{k ? -0.5f : 0.5f, 0, 0} + random_vector(random, 0.2f));
        before += world.particle_mass(ids[k]) * velocities.back();
        magnitude += double{world.particle_mass(ids[k])} * length(velocities.back());
      }
      world.add_particles(ids[k], points, velocities);
    }
    run(world, 60, 0.005f);
    Vec3 after{0, 0, 0};
    for (size_t i = 0; i < world.particle_count(); ++i)
      after += world.particle_mass(ids[world.fluids()[i]]) * world.velocities()[i];
    EXPECT_NEAR(length(after - before) / magnitude, 0, 1e-5) << ratio;
  }
}

TEST_P(GrainsTest, ReadOutsLeaveThemOut) {
  World world(def());
  const FluidId id = world.create_granular(sand());
  std::vector<Vec3> points = lattice(6, 6, 6, 0.6f * s, {0, 0, 0});
  world.add_particles(id, points);
  for (float error : world.density_errors()) EXPECT_EQ(error, 0);
  world.step(0.001f);
  for (float pressure : world.pressures()) EXPECT_EQ(pressure, 0);
  EXPECT_EQ(world.diagnostics().density_error_max, 0);
}

TEST_P(GrainsTest, TheSameBitsEachTimeAndWithAnyThreads) {
  const ManyThreads many;
  uint64_t first = 0;
  for (int threads : {1, 3, 8}) {
    WorldDef d = def();
    d.threads = threads;
    FluidId id;
    World world = poured(d, 12, &id);
    world.add_fluid(block(world.create_fluid({}), {-3 * s, 20 * s, -3 * s}, {3 * s, 26 * s, 3 * s}));
    run(world, 30, 1.0f / 60);
    world.remove_particles(std::vector<ParticleId>{0, 7, 100});
    world.add_particles(id, std::vector<Vec3>{{0, 60 * s, 0}});
    run(world, 30, 1.0f / 60);
    if (!first) first = world.state_hash();
    EXPECT_EQ(world.state_hash(), first) << threads;
  }
}

TEST_P(GrainsTest, MeasuringInBetweenChangesNothing) {
  uint64_t hash[2];
  for (int k : {0, 1}) {
    World world = poured(def(), 12);
    for (int step = 0; step < 40; ++step) {
      world.step(1.0f / 60);
      if (k) world.density_errors();
    }
    hash[k] = world.state_hash();
  }
  EXPECT_EQ(hash[0], hash[1]);
}

TEST_P(GrainsTest, APileAtRestStaysWhenGrainsGoAndCome) {
  FluidId id;
  World world = poured(def(), 12, &id);
  run(world, 90, 1.0f / 60);
  const double before = mean_height(world);
  // The topmost grain is removed, and another is added: the others keep their supporting contacts.
  size_t top = 0;
  for (size_t i = 0; i < world.particle_count(); ++i)
    if (world.positions()[i].y > world.positions()[top].y) top = i;
  const Vec3 place = world.positions()[top];
  world.remove_particles(std::vector<ParticleId>{world.ids()[top]});
  world.add_particles(id, std::vector<Vec3>{place});
  world.step(1.0f / 60);
  EXPECT_LT(fastest(world), 0.2f);  // the new one has g·dt
  run(world, 10, 1.0f / 60);
  EXPECT_LT(fastest(world), 0.01f);
  EXPECT_NEAR(mean_height(world), before, 0.05f * s);
}

// What comes between two steps takes the places of what has gone, not its contacts.
TEST_P(GrainsTest, APileAtRestDoesNotFeelWhatGoesAndComesElsewhere) {
  const auto velocities_in_pile = [&](bool exchanges) {
    World world(def());
    ShapeDef ground;
    ground.surface.friction = 0.6f;
    world.create_shape(ground);
    const FluidId id = world.create_granular(sand());
    world.add_fluid(block(id, {-5 * s, 0, -5 * s}, {5 * s, 8 * s, 5 * s}));
    const size_t pile = world.particle_count();
    std::vector<Vec3> elsewhere;
    for (int k = 0; k < 150; ++k) elsewhere.push_back({2 * s * static_cast<float>(k), 0.5f * s, 50 * s});
    world.add_particles(id, elsewhere);
    run(world, 120, 1.0f / 60);
    if (exchanges) {
      const std::vector<ParticleId> gone(world.ids().begin() + static_cast<std::ptrdiff_t>(pile),
                                         world.ids().end());
      world.remove_particles(gone);
      world.add_particles(id, elsewhere);
    }
    world.step(1.0f / 60);
    const auto all = world.velocities().first(pile);
    return std::vector<Vec3>(all.begin(), all.end());
  };
  EXPECT_EQ(velocities_in_pile(true), velocities_in_pile(false));
}

MENISCUS_ON_EACH_DEVICE(GrainsTest);

TEST(GranularDefTest, RefusesWhatMakesNoSense) {
  World world(world_def(pbd::DeviceKind::cpu, s));
  GranularDef def = sand();
  def.density = 0;
  expect_error(ErrorCode::invalid_argument, "GranularDef::density is 0", [&] { world.create_granular(def); });
  def = sand(1600, -0.1f);
  expect_error(ErrorCode::invalid_argument, "GranularDef::friction is -0.1",
               [&] { world.create_granular(def); });
}

}  // namespace
}  // namespace meniscus::tests
