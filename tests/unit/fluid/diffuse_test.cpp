// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of spray, foam and bubbles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "fluid/diffuse/diffuse_kernels.h"
#include "tests/many_threads.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;

std::vector<DiffuseParticle> copy_of(const World& world) {
  return {world.diffuse().begin(), world.diffuse().end()};
}

bool same(const std::vector<DiffuseParticle>& a, const std::vector<DiffuseParticle>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(DiffuseParticle)) == 0;
}

size_t count_of(const World& world, DiffuseKind kind) {
  const auto all = world.diffuse();
  return static_cast<size_t>(
      std::count_if(all.begin(), all.end(), [&](const DiffuseParticle& p) { return p.kind == kind; }));
}

double share_of(const World& world, DiffuseKind kind) {
  return static_cast<double>(count_of(world, kind)) / static_cast<double>(world.diffuse().size());
}

double mean_foam_height(const World& world) {
  double sum = 0;
  for (const DiffuseParticle& p : world.diffuse()) sum += double{p.position.y};
  return sum / static_cast<double>(world.diffuse().size());
}

class DiffuseTest : public OnDevice {
 protected:
  WorldDef def(const DiffuseDef& diffuse = {}) const {
    WorldDef def = world_def(GetParam(), s);
    def.diffuse = diffuse;
    return def;
  }

  /// Two blocks of water that meet at 4 m/s without gravity.
  static World collision_of(WorldDef def) {
    def.gravity = {0, 0, 0};
    return blocks_that_meet(def);
  }
  /// The same with it.
  static World blocks_that_meet(const WorldDef& def) {
    World world(def);
    const FluidId water = world.create_fluid({});
    for (const float side : {-1.0f, 1.0f}) {
      std::vector<Vec3> points = lattice(8, 8, 8, s, {side < 0 ? -9 * s : s, 0, 0});
      world.add_particles(water, points, std::vector<Vec3>(points.size(), Vec3{-2 * side, 0, 0}));
    }
    return world;
  }
};

TEST_P(DiffuseTest, SprayFallsByTheWorldsPresentGravity) {
  const WorldDef down = def();
  WorldDef none = def();
  none.gravity = {0, 0, 0};
  std::vector<DiffuseParticle> seen[2];
  for (const bool later : {false, true}) {
    World world = blocks_that_meet(later ? none : down);
    world.set_def(down);
    run(world, 20, 0.008f);
    seen[later] = copy_of(world);
  }
  EXPECT_GT(seen[0].size(), 20u);
  EXPECT_TRUE(same(seen[0], seen[1]));
}

TEST_P(DiffuseTest, WithoutTheOptionThereIsNone) {
  World world = dam_break(GetParam());
  const StepReport report = world.step(0.016f);
  EXPECT_TRUE(world.diffuse().empty());
  EXPECT_EQ(report.diffuse, 0u);
}

TEST_P(DiffuseTest, WaterAtRestMakesNone) {
  World world(def());
  world.create_shape(tank({0, 0, 0}, {0.5f, 1, 0.5f}));
  world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.5f, 0.4f, 0.5f}));
  run(world, 30, 0.016f);
  EXPECT_EQ(world.diffuse().size(), 0u);
}

TEST_P(DiffuseTest, NorDoesABlockThatFallsAsOne) {
  World world(def());
  const auto points = lattice(8, 8, 8, s, {0, 0, 0});
  world.add_particles(world.create_fluid({}), points, std::vector<Vec3>(points.size(), Vec3{0, -5, 0}));
  run(world, 5, 0.016f);
  EXPECT_EQ(world.diffuse().size(), 0u) << "fast, but no air is trapped, and no wave breaks";
}

TEST_P(DiffuseTest, WhereBlocksMeetAirIsTrapped) {
  World world = collision_of(def({.air_rate = 1000}));
  size_t most = 0;
  for (int k = 0; k < 8; ++k) most = std::max(most, size_t{world.step(0.008f).diffuse});
  EXPECT_GT(most, 100u);
  for (const DiffuseParticle& p : world.diffuse()) {
    EXPECT_TRUE(is_finite(p.position));
    EXPECT_GT(p.life, 0);
    EXPECT_LT(length(p.velocity), 20);
  }
}

TEST_P(DiffuseTest, RatesAreInProportionAndZeroMakesNone) {
  const auto made = [&](float air, float crest) {
    DiffuseDef d;
    d.air_rate = air;
    d.crest_rate = crest;
    World world = collision_of(def(d));
    run(world, 8, 0.008f);
    return static_cast<double>(world.diffuse().size());
  };
  EXPECT_EQ(made(0, 0), 0);
  EXPECT_NEAR(made(8000, 0) / made(2000, 0), 4, 0.2);
  EXPECT_GT(made(0, 1000), 0) << "crests";
}

TEST_P(DiffuseTest, TheNumberDoesNotDependOnTheStep) {
  const auto made = [&](int steps) {
    World world = collision_of(def({.air_rate = 500}));
    run(world, steps, 0.048f / static_cast<float>(steps));
    return static_cast<double>(world.diffuse().size());
  };
  EXPECT_NEAR(made(12) / made(6), 1, 0.15);
}

TEST_P(DiffuseTest, SprayFliesInAParabola) {
  DiffuseDef d;
  d.lifetime = {50, 60};
  d.air_rate = 1000;
  WorldDef with_gravity = def(d);
  World world(with_gravity);
  const FluidId water = world.create_fluid({});
  // Two jets that meet, and then nothing is near what they throw up.
  for (const float side : {-1.0f, 1.0f}) {
    std::vector<Vec3> points = lattice(5, 5, 5, s, {side < 0 ? -6 * s : s, 0, 0});
    world.add_particles(water, points, std::vector<Vec3>(points.size(), Vec3{-3 * side, 0, 0}));
  }
  run(world, 12, 0.008f);
  std::vector<ParticleId> all(world.ids().begin(), world.ids().end());
  world.remove_particles(all);
  const std::vector<DiffuseParticle> before = copy_of(world);
  ASSERT_GT(before.size(), 10u);
  run(world, 10, 0.008f);
  const std::vector<DiffuseParticle> after = copy_of(world);
  ASSERT_EQ(after.size(), before.size());
  EXPECT_EQ(count_of(world, DiffuseKind::spray), after.size());
  for (size_t i = 0; i < after.size(); ++i) {
    const float t = 0.08f;
    EXPECT_NEAR(after[i].velocity.y, before[i].velocity.y - 9.81f * t, 1e-4f);
    EXPECT_NEAR(after[i].position.x, before[i].position.x + t * before[i].velocity.x, 1e-4f);
    EXPECT_NEAR(after[i].position.y,
                before[i].position.y + t * before[i].velocity.y - 0.5f * 9.81f * t * (t + 0.008f), 1e-4f);
    EXPECT_NEAR(after[i].life, before[i].life - t, 1e-4f);
  }
}

TEST_P(DiffuseTest, TheyGoWhenTheirTimeIsOver) {
  DiffuseDef d;
  d.lifetime = {0.05f, 0.1f};
  d.air_rate = 1000;
  World world = collision_of(def(d));
  run(world, 6, 0.008f);
  ASSERT_GT(world.diffuse().size(), 0u);
  std::vector<ParticleId> all(world.ids().begin(), world.ids().end());
  world.remove_particles(all);
  run(world, 13, 0.008f);
  EXPECT_EQ(world.diffuse().size(), 0u);
}

TEST_P(DiffuseTest, InTheWaterThereAreBubblesThatRiseAndFoamThatFloats) {
  // A block falls into a pool that is then left alone.
  DiffuseDef d;
  d.lifetime = {20, 30};
  d.air_rate = 300;
  World world(def(d));
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {0.4f, 3, 0.4f}));
  world.add_fluid(block(water, {0, 0, 0}, {0.4f, 0.3f, 0.4f}));
  const std::vector<Vec3> points = lattice(4, 4, 4, s, {0.1f, 0.5f, 0.1f});
  world.add_particles(water, points, std::vector<Vec3>(points.size(), Vec3{0, -4, 0}));
  run(world, 20, 0.016f);
  const double level = static_cast<double>(world.particle_count()) * std::pow(double{s}, 3) / (0.4 * 0.4);
  const double bubbles_before = share_of(world, DiffuseKind::bubble),
               depth_before = level - mean_foam_height(world);
  EXPECT_GT(bubbles_before, 0.2);
  run(world, 150, 0.016f);
  ASSERT_GT(world.diffuse().size(), 50u);
  EXPECT_LT(share_of(world, DiffuseKind::bubble), 0.5 * bubbles_before);
  EXPECT_GT(share_of(world, DiffuseKind::foam), 0.5);
  EXPECT_LT(level - mean_foam_height(world), 0.5 * depth_before);
  EXPECT_LT(level - mean_foam_height(world), double{s});
}

TEST_P(DiffuseTest, SolidsKeepThemOut) {
  World world(def());
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {1, 1, 0.5f}));
  world.create_shape(shape(SphereGeometry{0.2f}, {0.7f, 0.1f, 0.25f}));
  world.add_fluid(block(water, {0, 0, 0}, {0.4f, 0.8f, 0.5f}));
  size_t most = 0;
  for (int k = 0; k < 40; ++k) {
    world.step(0.016f);
    most = std::max(most, world.diffuse().size());
    for (const DiffuseParticle& p : world.diffuse()) {
      EXPECT_GT(p.position.x, -1e-4f);
      EXPECT_LT(p.position.x, 1 + 1e-4f);
      EXPECT_GT(p.position.y, -1e-4f);
      EXPECT_GT(p.position.z, -1e-4f);
      EXPECT_LT(p.position.z, 0.5f + 1e-4f);
      EXPECT_GT(length(p.position - Vec3{0.7f, 0.1f, 0.25f}), 0.2f - 1e-3f);
    }
  }
  EXPECT_GT(most, 100u);
}

TEST_P(DiffuseTest, TheyHaveNoEffectOnTheFluid) {
  World with = collision_of(def({.air_rate = 1000})), without = collision_of(world_def(GetParam(), s));
  run(with, 10, 0.008f);
  run(without, 10, 0.008f);
  EXPECT_GT(with.diffuse().size(), 0u);
  EXPECT_EQ(with.state_hash(), without.state_hash());
}

TEST_P(DiffuseTest, ThereAreNoMoreThanTheCapacityAndTheRestIsCounted) {
  DiffuseDef d;
  d.capacity = 50;
  d.air_rate = 1000;
  World world = collision_of(def(d));
  uint32_t refused = 0;
  for (int k = 0; k < 8; ++k) {
    const StepReport report = world.step(0.008f);
    EXPECT_LE(report.diffuse, 50u);
    refused += report.diffuse_refused;
  }
  EXPECT_EQ(world.diffuse().size(), 50u);
  EXPECT_GT(refused, 0u);
}

TEST_P(DiffuseTest, MemoryIsTakenAtTheStart) {
  DiffuseDef d;
  d.capacity = 1000;
  DiffuseDef more = d;
  more.capacity = 101000;
  EXPECT_NEAR(static_cast<double>(World(def(more)).device_bytes() - World(def(d)).device_bytes()), 104e5,
              1e3);
}

TEST_P(DiffuseTest, EqualRunsGiveEqualBits) {
  const auto run_once = [&](int threads) {
    WorldDef with = def();
    with.threads = threads;
    with.diffuse->air_rate = 1000;
    World world = dam_break(with);
    run(world, 20, 0.016f);
    return copy_of(world);
  };
  const ManyThreads many;
  const std::vector<DiffuseParticle> first = run_once(1);
  EXPECT_GT(first.size(), 100u);
  EXPECT_TRUE(same(first, run_once(8)));
}

TEST_P(DiffuseTest, AStepThatFailsLeavesThemAsTheyWere) {
  World world = collision_of(def({.air_rate = 1000}));
  run(world, 5, 0.008f);
  const std::vector<DiffuseParticle> before = copy_of(world);
  ASSERT_GT(before.size(), 10u);
  const Vec3 away[] = {{0, 3, 0}}, mad[] = {{3e38f, 3e38f, 3e38f}};
  world.add_particles(world.create_fluid({}), away, mad);
  EXPECT_THROW(world.step(1000), Error);
  EXPECT_TRUE(same(copy_of(world), before));
}

TEST_P(DiffuseTest, WrongArgumentsAreNamed) {
  const auto message = [&](const DiffuseDef& d) {
    try {
      World world(def(d));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message({}), "");
  EXPECT_EQ(message({.capacity = 0}),
            "DiffuseDef::capacity is 0; it must be at least 1 and at most 67108864");
  EXPECT_EQ(message({.air = {2, 1}}), "DiffuseDef::air.low is 2; low must be below high");
  EXPECT_NE(message({.lifetime = {-1, 1}}).find("lifetime"), std::string::npos);
  EXPECT_NE(message({.drag = std::nanf("")}).find("drag"), std::string::npos);
  EXPECT_NE(message({.spray_below = 0.5f, .bubbles_above = 0.4f}).find("bubbles_above"), std::string::npos);
}

MENISCUS_ON_EACH_DEVICE(DiffuseTest);

TEST(RandomNumbers, AreEvenAndWithoutCorrelation) {
  constexpr int count = 100000;
  double mean[3] = {}, square[3] = {}, product = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const Vec3 r = pbd::random_numbers(i, 7, 1);
    const float values[] = {r.x, r.y, r.z};
    for (int k = 0; k < 3; ++k) {
      ASSERT_GE(values[k], 0);
      ASSERT_LT(values[k], 1);
      mean[k] += double{values[k]} / count;
      square[k] += double{values[k]} * values[k] / count;
    }
    product += double{r.x} * pbd::random_numbers(i + 1, 7, 1).x / count;
  }
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(mean[k], 0.5, 0.005);
    EXPECT_NEAR(square[k], 1.0 / 3, 0.005);
  }
  EXPECT_NEAR(product, 0.25, 0.005) << "one follows from the one before";
}

}  // namespace
}  // namespace meniscus::tests
