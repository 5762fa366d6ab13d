// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Emitters, sinks, probes and bodies of a world on several ranks: the same bits as alone.
#include <gtest/gtest.h>

#include "tests/ranks/bodies.h"
#include "tests/ranks/broken_dam.h"
#include "tests/ranks/flow.h"
#include "tests/ranks/share.h"

namespace meniscus::tests {
namespace {

constexpr float frame = 0.008f;                // s
constexpr float width = 0.15f, length = 1.3f;  // m

World dam() {
  return broken_dam(width, length, true, {}, true);
}

World dam_with_flow() {
  World world = dam();
  add_flow(world, width, length);
  return world;
}

World dam_with_bodies() {
  World world = dam();
  add_bodies(world, width, length);
  return world;
}

World dam_with_bodies_on_device() {
  World world = broken_dam(width, length, true, {}, true, RigidSolver::device);
  add_bodies(world, width, length);
  return world;
}

World dam_with_all() {
  World world = dam_with_flow();
  add_bodies(world, width, length);
  return world;
}

/// What a world tells after each fifth step.
std::vector<std::string> told(World& world, int steps) {
  std::vector<std::string> all;
  for (int k = 0; k < steps; ++k) {
    world.step(frame);
    if (k % 5 != 4) continue;
    all.push_back(std::to_string(world.state_hash()));
    all.push_back(told_by_flow(world));
    all.push_back(told_by_bodies(world));
  }
  return all;
}

void expect_the_same(const std::function<World()>& make, int steps) {
  tests::expect_the_same(make, [&](World& world) { return told(world, steps); });
}

TEST(SharedContents, EmittersSinksAndProbesHaveTheSameBits) {
  expect_the_same(dam_with_flow, 20);
}

TEST(SharedContents, AJetFillsAnEmptyTank) {
  WorldDef def = world_def(pbd::DeviceKind::cpu, 0.05f);
  def.threads = 1;
  expect_the_same([&] { return jet_into_an_empty_tank(def); }, 60);
}

TEST(SharedContents, BodiesHaveTheSameBits) {
  expect_the_same(dam_with_bodies, 15);
}

TEST(SharedContents, BodiesOfTheDeviceHaveTheSameBits) {
  expect_the_same(dam_with_bodies_on_device, 10);
}

TEST(SharedContents, FlowAndBodiesAreThereInTheTest) {
  World world = dam_with_all();
  tests::run(world, 20, frame);
  for (const EmitterId id : world.emitter_ids()) EXPECT_GT(world.emitter_count(id).total, 0u);
  for (const SinkId id : world.sink_ids()) EXPECT_GT(world.sink_count(id).total, 0u);
  for (const ProbeId id : world.probe_ids()) EXPECT_NE(world.probe(id), 0);
  for (const BodyId id : world.body_ids()) EXPECT_NE(world.body_state(id).fluid_force.y, 0);
}

TEST(SharedContents, GoOnFromAFileAloneAndOnOtherRanks) {
  const std::string file = testing::TempDir() + "/shared_contents.menisnap";
  std::vector<std::string> expected;
  auto errors = share(3, restless_slabs, dam_with_all, [&](World& world) {
    tests::run(world, 12, frame);
    world.save(file);
    expected = told(world, 10);
  });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
  World alone = World::load(file);
  EXPECT_EQ(told(alone, 10), expected);
  errors = share(
      2, {}, [&] { return World::load(file); }, [&](World& world) { EXPECT_EQ(told(world, 10), expected); });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
}

TEST(SharedContents, EachRankKnowsTheIdsOfItsParticles) {
  constexpr int count = 3;
  const auto ranks = make_thread_ranks(count);
  std::vector<ParticlesOfRank> own(count);
  std::vector<ParticleId> ids;
  std::vector<Vec3> positions;
  const auto run = [&](int r) {
    World world = dam_with_flow();
    SharedWorld shared(world, *ranks[static_cast<size_t>(r)], restless_slabs);
    if (shared.leads()) {
      tests::run(world, 10, frame);
      ids.assign(world.ids().begin(), world.ids().end());
      positions.assign(world.positions().begin(), world.positions().end());
      shared.pause();
    } else {
      EXPECT_TRUE(shared.follow());
    }
    own[static_cast<size_t>(r)] = shared.read_own_particles();
    if (shared.leads()) return;
    EXPECT_FALSE(shared.follow());
  };
  {
    std::jthread first(run, 1), second(run, 2);
    run(0);
  }
  size_t found = 0;
  for (const ParticlesOfRank& p : own) {
    found += p.ids.size();
    for (size_t k = 0; k < p.ids.size(); ++k) {
      const auto at = std::lower_bound(ids.begin(), ids.end(), p.ids[k]);
      ASSERT_TRUE(at != ids.end() && *at == p.ids[k]);
      EXPECT_TRUE(positions[static_cast<size_t>(at - ids.begin())] == p.positions[k]);
    }
  }
  EXPECT_EQ(found, ids.size());
}

/// In the middle of steps, sums over bodies, emission and removal.
TEST(SharedContents, AFailureOfOneRankEndsAll) {
  for (int call = 40; call < 400; call += 31) expect_failure_to_end_all(dam_with_all, call, 10);
}

/// Water of the size of a grain has little mass, so what moves coarse particles is beyond its sums.
TEST(SharedContents, ForcesBeyondTheSumsAreReported) {
  const auto errors = share(
      3, {},
      [] {
        World world = dam();
        BodyDef grain;
        grain.motion = BodyMotion::kinematic;
        grain.geometry = SphereGeometry{1e-3f};
        grain.keyframes = {{0, {{0.5f * width, 0.9f, 0.5f}}}, {0.1f, {{0.5f * width, 0.1f, 0.5f}}}};
        world.create_body(grain);
        return world;
      },
      [](World& world) { tests::run(world, 12, frame); });
  for (const std::string& error : errors)
    EXPECT_NE(error.find("a particle pushes body 0 harder than sums over ranks have room for"),
              std::string::npos)
        << error;
}

TEST(SharedContents, DropsThatMeetOnABodyKeepMomentum) {
  const auto errors = share(
      3, {}, [] { return free_drops(true); },
      [](World& world) {
        const Momentum before = momentum_of(world);
        tests::run(world, 100, frame);
        const Momentum after = momentum_of(world);
        EXPECT_NE(world.body_state(world.body_ids()[0]).velocity.x, 0);
        const double scale = after.mass * double{drop_speed};
        EXPECT_NEAR(after.x, before.x, 1e-6 * scale);
        EXPECT_NEAR(after.y, before.y, 1e-6 * scale);
        EXPECT_NEAR(after.z, before.z, 1e-6 * scale);
      });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
}

}  // namespace
}  // namespace meniscus::tests
