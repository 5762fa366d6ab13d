// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// One world that is cut along two axes, on each device: the same bits as alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "pbd/math/hash.h"
#include "tests/expect_error.h"
#include "tests/ranks/bodies.h"
#include "tests/ranks/broken_dam.h"
#include "tests/ranks/flow.h"
#include "tests/ranks/share.h"

namespace meniscus::tests {
namespace {

constexpr float frame = 0.008f;                // s
constexpr float width = 0.15f, length = 1.3f;  // m

/// Two by two, also where they move, and three that meet in a T.
const Sharing four_and_three = {{4, pencils}, {4, restless_pencils}, {3, restless_pencils}};

class SharedPencils : public OnDevice {
 protected:
  WorldDef def() const {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.sums = Sums::fixed;
    def.threads = 1;
    return def;
  }
  World dam() const {
    const bool is_cuda = GetParam() == pbd::DeviceKind::cuda;
    return broken_dam(width, length, true, is_cuda ? std::optional(0) : std::nullopt, true);
  }
  World dam_with_all() const {
    World world = dam();
    add_flow(world, width, length);
    add_bodies(world, width, length);
    return world;
  }

  /// A tall block that breaks onto a ball, with spray, foam and bubbles, and a wall that pushes more water
  /// in.
  World surf() const {
    WorldDef d = def();
    d.diffuse.emplace();
    d.diffuse->capacity = 2000;
    d.diffuse->lifetime = {0.03f, 0.3f};
    d.diffuse->air = {0.1f, 1};  // some everywhere
    World world(d);
    EmitterDef duct;
    duct.fluid = world.create_fluid({});
    world.create_shape(tank({0, 0, 0}, {0.3f, 1.2f, 1.6f}));
    world.create_shape(shape(SphereGeometry{0.15f}, {0.15f, 0.1f, 1.1f}));
    FluidVolumeDef volume = block(duct.fluid, {0, 0, 0}, {0.3f, 0.8f, 0.8f});
    volume.velocity = {0, 0, 3};
    world.add_fluid(volume);
    duct.opening = RectangleOpening{0.1f, 0.1f};
    duct.pose = {{0, 0.4f, 0.4f}, about_z(-90)};  // out along x, where four ranks meet
    duct.speed = 1;
    duct.mode = EmitterMode::imposed;
    world.create_emitter(duct);
    return world;
  }
};

/// After each fifth step.
template <int steps>
std::vector<std::string> hashes_told(World& world) {
  std::vector<std::string> all;
  for (int k = 0; k < steps; ++k) {
    world.step(frame);
    if (k % 5 == 4) all.push_back(std::to_string(world.state_hash()));
  }
  return all;
}

std::vector<std::string> all_told(World& world) {
  std::vector<std::string> all;
  for (int k = 0; k < 9; ++k) {
    world.step(frame);
    if (k % 3 == 2)
      all.push_back(std::to_string(world.state_hash()) + " " + told_by_flow(world) + told_by_bodies(world));
  }
  return all;
}

std::vector<std::string> surf_told(World& world) {
  std::vector<std::string> all;
  for (int k = 0; k < 12; ++k) {
    const StepReport report = world.step(frame);
    uint64_t hash = 0;
    for (const DiffuseParticle& p : world.diffuse())
      hash = pbd::mixed(hash) + pbd::element_hash(static_cast<uint64_t>(p.kind), p.position,
                                                  p.velocity + p.life * Vec3{1, 2, 3});
    all.push_back(std::to_string(world.state_hash()) + " " + std::to_string(hash) + " " +
                  std::to_string(report.diffuse_refused) + " " + std::to_string(world.particle_count()) +
                  " " + std::to_string(world.emitter_pressure(world.emitter_ids()[0])));
  }
  EXPECT_GT(world.diffuse().size(), 100u);
  EXPECT_GT(world.emitter_count(world.emitter_ids()[0]).total, 0u);
  return all;
}

TEST_P(SharedPencils, FluidsHaveTheSameBits) {
  expect_the_same([&] { return dam(); }, hashes_told<30>, four_and_three);
}

TEST_P(SharedPencils, FlowAndBodiesHaveTheSameBits) {
  expect_the_same([&] { return dam_with_all(); }, all_told, four_and_three);
}

TEST_P(SharedPencils, SprayAndImposedEmittersHaveTheSameBits) {
  expect_the_same([&] { return surf(); }, surf_told, {{4, pencils}, {3, restless_pencils}});
}

/// With the slabs' axis along y.
TEST_P(SharedPencils, APoolUnderGravityAlongZHasTheSameBits) {
  expect_the_same(
      [&] {
        WorldDef d = def();
        d.gravity = {0, 0, -9.81f};
        World world(d);
        world.create_shape(tank({0, 0, 0}, {0.15f, 2, 1}));
        world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.15f, 1, 0.8f}));
        return world;
      },
      hashes_told<15>, {{4, restless_pencils}});
}

/// Far rows share entries of the table with near ones.
TEST_P(SharedPencils, FluidFarApartHasTheSameBits) {
  expect_the_same(
      [&] {
        World world(def());
        const FluidId fluid = world.create_fluid({});
        world.add_fluid(block(fluid, {0, 0, 0}, {0.15f, 0.8f, 0.8f}));
        world.add_fluid(block(fluid, {0, 1.6f, 40}, {0.15f, 2.4f, 40.8f}));
        world.add_fluid(block(fluid, {0, 30, 0.2f}, {0.15f, 30.7f, 0.9f}));
        world.create_shape(shape(SphereGeometry{0.5f}, {0.1f, -0.4f, 0.4f}));
        return world;
      },
      hashes_told<10>, {{3, pencils}, {5, restless_pencils}});
}

/// Some ranks have nothing at first.
TEST_P(SharedPencils, AJetIntoAnEmptyTankHasTheSameBits) {
  expect_the_same([&] { return jet_into_an_empty_tank(def()); }, hashes_told<40>, {{4, pencils}});
}

TEST_P(SharedPencils, GoOnFromAFileAloneAndInSlabs) {
  const std::string file = testing::TempDir() + "/shared_pencils.menisnap";
  std::vector<std::string> expected;
  const auto make = [&] { return dam_with_all(); };
  auto errors = share(4, restless_pencils, make, [&](World& world) {
    tests::run(world, 3, frame);
    world.save(file);
    expected = all_told(world);
  });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
  World alone = World::load(file);
  EXPECT_EQ(all_told(alone), expected);
  errors = share(
      2, slabs, [&] { return World::load(file); },
      [&](World& world) { EXPECT_EQ(all_told(world), expected); });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
}

/// Four ranks each have a quarter of the dam, below or above a cut, and before or behind another.
TEST_P(SharedPencils, EachRankHasTheParticlesInItsRectangle) {
  constexpr int count = 4;
  const auto ranks = make_thread_ranks(count);
  std::array<ParticlesOfRank, count> own;
  std::vector<ParticleId> ids;
  const auto run = [&](int r) {
    World world = dam();
    SharedWorld shared(world, *ranks[static_cast<size_t>(r)], pencils);
    if (shared.leads()) {
      tests::run(world, 2, frame);
      ids.assign(world.ids().begin(), world.ids().end());
      shared.pause();
    } else {
      EXPECT_TRUE(shared.follow());
    }
    own[static_cast<size_t>(r)] = shared.read_own_particles();
    if (shared.leads()) return;
    EXPECT_FALSE(shared.follow());
  };
  {
    std::vector<std::jthread> others;
    for (int r = 1; r < count; ++r) others.emplace_back(run, r);
    run(0);
  }
  std::map<ParticleId, int> found;
  std::array<Aabb, count> extents;
  for (size_t r = 0; r < count; ++r) {
    ASSERT_GT(own[r].positions.size(), ids.size() / 5);
    extents[r] = {own[r].positions[0], own[r].positions[0]};
    for (const Vec3& p : own[r].positions)
      extents[r] = {{0, std::min(extents[r].lower.y, p.y), std::min(extents[r].lower.z, p.z)},
                    {0, std::max(extents[r].upper.y, p.y), std::max(extents[r].upper.z, p.z)}};
    for (const ParticleId id : own[r].ids) ++found[id];
  }
  EXPECT_EQ(found.size(), ids.size());
  for (const auto& [id, times] : found) EXPECT_EQ(times, 1) << id;
  int along_y = 0, along_z = 0;
  for (size_t a = 0; a < count; ++a) {
    for (size_t b = a + 1; b < count; ++b) {
      along_y += extents[a].upper.y < extents[b].lower.y || extents[b].upper.y < extents[a].lower.y;
      along_z += extents[a].upper.z < extents[b].lower.z || extents[b].upper.z < extents[a].lower.z;
    }
  }
  EXPECT_GE(along_z, 4);
  EXPECT_GE(along_y, 2);
}

TEST_P(SharedPencils, KeepMomentum) {
  if (GetParam() == pbd::DeviceKind::cuda) GTEST_SKIP() << "the drops are on the CPU";
  const auto errors = share(
      4, pencils, [] { return free_drops(true); },
      [](World& world) {
        const Momentum before = momentum_of(world);
        tests::run(world, 50, frame);
        const Momentum after = momentum_of(world);
        EXPECT_NE(world.body_state(world.body_ids()[0]).velocity.x, 0);
        const double scale = after.mass * double{drop_speed};
        EXPECT_NEAR(after.x, before.x, 1e-6 * scale);
        EXPECT_NEAR(after.y, before.y, 1e-6 * scale);
        EXPECT_NEAR(after.z, before.z, 1e-6 * scale);
      });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
}

TEST_P(SharedPencils, RefuseThePressureGrid) {
  WorldDef d = def();
  d.density.solver = DensitySolver::grid;
  World world(d);
  const auto ranks = make_thread_ranks(1);
  expect_error(ErrorCode::invalid_argument, "pressure grid", [&] { SharedWorld(world, *ranks[0], pencils); });
}

TEST_P(SharedPencils, NeedThreeLayersARank) {
  const auto errors = share(
      9, pencils, [&] { return dam(); }, [](World&) {});
  for (const std::string& error : errors)
    EXPECT_NE(error.find("along the axes of its pencils; 9 ranks need 3 each"), std::string::npos) << error;
}

MENISCUS_ON_EACH_DEVICE(SharedPencils);

}  // namespace
}  // namespace meniscus::tests
