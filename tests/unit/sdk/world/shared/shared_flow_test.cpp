// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Spray, foam and bubbles, and imposed emitters, of a world on several ranks: the same bits as alone.
#include <gtest/gtest.h>

#include <sstream>

#include "pbd/math/hash.h"
#include "tests/ranks/broken_dam.h"
#include "tests/ranks/share.h"

namespace meniscus::tests {
namespace {

constexpr float frame = 0.008f;  // s

class SharedFlow : public OnDevice {
 protected:
  WorldDef def() const {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.sums = Sums::fixed;
    def.threads = 1;
    return def;
  }

  /// A fast block that breaks onto a ball, along the slabs, with at most so much spray, foam and bubbles.
  World surf(uint32_t capacity) const {
    WorldDef d = def();
    d.diffuse.emplace();
    d.diffuse->capacity = capacity;
    d.diffuse->lifetime = {0.03f, 0.3f};
    d.diffuse->air = {0.1f, 1};  // some everywhere
    World world(d);
    const FluidId fluid = world.create_fluid({});
    world.create_shape(tank({0, 0, 0}, {0.3f, 1, 2}));
    world.create_shape(shape(SphereGeometry{0.15f}, {0.15f, 0.1f, 1.1f}));
    FluidVolumeDef volume = block(fluid, {0, 0, 0}, {0.3f, 0.4f, 0.9f});
    volume.velocity = {0, 0, 4};
    world.add_fluid(volume);
    return world;
  }

  /// Water at rest in a closed trough, into which an opening in one of its walls pushes more.
  World duct(float stop) const {
    World world(def());
    EmitterDef e;
    e.fluid = world.create_fluid({});
    world.create_shape(tank({0, 0, 0}, {0.4f, 1, 1.5f}));
    world.add_fluid(block(e.fluid, {0, 0, 0}, {0.4f, 0.5f, 1.5f}));
    e.opening = RectangleOpening{0.2f, 0.2f};
    e.pose = {{0, 0.2f, 0.7f}, about_z(-90)};  // out along x
    e.speed = 1;
    e.mode = EmitterMode::imposed;
    e.stop = stop;
    world.create_emitter(e);
    return world;
  }
};

std::string hex(uint64_t value) {
  std::ostringstream text;
  text << std::hex << value;
  return text.str();
}

/// The particles of spray, foam and bubbles in their order, bit for bit.
std::string told_by_diffuse(const World& world, const StepReport& report) {
  uint64_t hash = 0;
  for (const DiffuseParticle& p : world.diffuse())
    hash = pbd::mixed(hash) +
           pbd::element_hash(static_cast<uint64_t>(p.kind), p.position, p.velocity + p.life * Vec3{1, 2, 3});
  return std::to_string(world.diffuse().size()) + " " + std::to_string(report.diffuse_refused) + " " +
         hex(hash);
}

std::vector<std::string> surf_told(World& world) {
  std::vector<std::string> all;
  for (int k = 0; k < 20; ++k) {
    const StepReport report = world.step(frame);
    EXPECT_EQ(report.diffuse, world.diffuse().size());
    all.push_back(hex(world.state_hash()) + " " + told_by_diffuse(world, report));
  }
  return all;
}

TEST_P(SharedFlow, SprayFoamAndBubblesHaveTheSameBits) {
  expect_the_same([&] { return surf(1u << 14); }, surf_told);
}

/// The limit is that of all ranks together. Which births it refuses does not depend on their number.
TEST_P(SharedFlow, ACapacityOfSprayIsThatOfAllRanks) {
  expect_the_same([&] { return surf(100); }, surf_told);
}

TEST_P(SharedFlow, SprayIsThereInTheTest) {
  World world = surf(100);
  uint32_t refused = 0, kinds = 0;
  for (int k = 0; k < 20; ++k) {
    refused += world.step(frame).diffuse_refused;
    for (const DiffuseParticle& p : world.diffuse()) kinds |= 1u << static_cast<uint32_t>(p.kind);
  }
  EXPECT_GT(refused, 0u);
  EXPECT_EQ(world.diffuse().size(), 100u);
  EXPECT_EQ(kinds, 7u);
}

TEST_P(SharedFlow, SprayGoesOnFromAFile) {
  const std::string file = testing::TempDir() + "/shared_flow.menisnap";
  std::vector<std::string> expected;
  auto errors = share(
      3, restless_slabs, [&] { return surf(1u << 14); },
      [&](World& world) {
        tests::run(world, 10, frame);
        world.save(file);
        expected = surf_told(world);
      });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
  World alone = World::load(file);
  EXPECT_GT(alone.diffuse().size(), 0u);
  EXPECT_EQ(surf_told(alone), expected);
  errors = share(
      2, {}, [&] { return World::load(file); }, [&](World& world) { EXPECT_EQ(surf_told(world), expected); });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
}

TEST_P(SharedFlow, EachRankHasTheSprayInItsRegion) {
  const auto ranks = make_thread_ranks(2);
  std::vector<ParticlesOfRank> own(2);
  std::size_t all = 0;
  const auto run = [&](int r) {
    World world = surf(1u << 14);
    SharedWorld shared(world, *ranks[static_cast<size_t>(r)]);
    if (shared.leads()) {
      tests::run(world, 15, frame);
      all = world.diffuse().size();
      shared.pause();
    } else {
      EXPECT_TRUE(shared.follow());
    }
    own[static_cast<size_t>(r)] = shared.read_own_particles();
    if (shared.leads()) return;
    EXPECT_FALSE(shared.follow());
  };
  {
    std::jthread other(run, 1);
    run(0);
  }
  EXPECT_EQ(own[0].diffuse.size() + own[1].diffuse.size(), all);
  EXPECT_GT(own[0].diffuse.size(), 0u);
  EXPECT_GT(own[1].diffuse.size(), 0u);
}

std::vector<std::string> duct_told(World& world) {
  std::vector<std::string> all;
  for (int k = 0; k < 40; ++k) {
    world.step(frame);
    std::ostringstream text;
    text << hex(world.state_hash()) << ' ' << world.particle_count();
    for (const EmitterId id : world.emitter_ids())
      text << ' ' << world.emitter_count(id).total << ' ' << world.emitter_pressure(id);
    all.push_back(text.str());
  }
  return all;
}

TEST_P(SharedFlow, ImposedEmittersHaveTheSameBits) {
  expect_the_same([&] { return duct(1e9f); }, duct_told);
}

/// The layers in the duct are removed at the end.
TEST_P(SharedFlow, ImposedEmittersEnd) {
  expect_the_same([&] { return duct(0.2f); }, duct_told);
}

TEST_P(SharedFlow, AnImposedEmitterPushesInTheTest) {
  World world = duct(0.2f);
  float pressure = 0;
  std::size_t most = 0;
  for (int k = 0; k < 40; ++k) {
    world.step(frame);
    most = std::max(most, world.particle_count());
    pressure = std::max(pressure, static_cast<float>(world.emitter_pressure(world.emitter_ids()[0])));
  }
  EXPECT_GT(world.emitter_count(world.emitter_ids()[0]).total, 0u);
  EXPECT_LT(world.particle_count(), most);
  EXPECT_GT(pressure, 0);
}

MENISCUS_ON_EACH_DEVICE(SharedFlow);

}  // namespace
}  // namespace meniscus::tests
