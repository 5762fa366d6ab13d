// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// One world on several ranks, which are threads here: the same bits as on one, whatever the number of ranks
// and wherever the cuts are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <tuple>

#include "tests/expect_error.h"
#include "tests/ranks/broken_dam.h"
#include "tests/ranks/share.h"

namespace meniscus::tests {
namespace {

constexpr float frame = 0.008f;               // s
constexpr float wide = 0.3f, narrow = 0.15f;  // m

struct Result {
  std::vector<uint64_t> hashes;
  std::vector<Vec3> positions;
  std::vector<float> pressures, errors;
  Diagnostics diagnostics;
};

Result result_of(World& world, int steps) {
  Result result;
  for (int k = 0; k < steps; ++k) {
    world.step(frame);
    if (k % 10 == 9) result.hashes.push_back(world.state_hash());
  }
  const auto copy = [](const auto& from, auto& to) { to.assign(from.begin(), from.end()); };
  copy(world.positions(), result.positions);
  copy(world.pressures(), result.pressures);
  copy(world.density_errors(), result.errors);
  result.diagnostics = world.diagnostics();
  return result;
}

Result alone(int steps) {
  World world = broken_dam(wide);
  return result_of(world, steps);
}

Result together(int count, int steps, const pbd::CutPolicy& policy = slabs) {
  Result result;
  const auto errors = share(
      count, policy, [] { return broken_dam(wide); },
      [&](World& world) { result = result_of(world, steps); });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
  return result;
}

void expect_equal(const Result& a, const Result& b) {
  EXPECT_EQ(a.hashes, b.hashes);
  EXPECT_TRUE(std::ranges::equal(a.positions, b.positions));
  EXPECT_EQ(a.pressures, b.pressures);
  EXPECT_EQ(a.errors, b.errors);
  EXPECT_EQ(a.diagnostics.particles, b.diagnostics.particles);
  EXPECT_EQ(a.diagnostics.contacts, b.diagnostics.contacts);
  EXPECT_EQ(a.diagnostics.neighbours_mean, b.diagnostics.neighbours_mean);
  EXPECT_NEAR(a.diagnostics.kinetic_energy, b.diagnostics.kinetic_energy,
              1e-12 * a.diagnostics.kinetic_energy);
}

TEST(SharedWorld, HasTheSameBitsOnOneTwoAndThreeRanks) {
  const Result expected = alone(20);
  for (const int ranks : {1, 2, 3}) {
    SCOPED_TRACE(ranks);
    expect_equal(together(ranks, 20), expected);
  }
}

TEST(SharedWorld, HasTheSameBitsWhereCutsMoveWithEveryStep) {
  expect_equal(together(3, 20, restless_slabs), alone(20));
}

/// MENISCUS_RANK_STEPS=7500 is a minute.
TEST(SharedWorld, KeepsEachParticleOnce) {
  const char* const set = std::getenv("MENISCUS_RANK_STEPS");
  const int steps = set ? std::atoi(set) : 60;
  std::vector<ParticleId> ids;
  const auto errors = share(
      3, restless_slabs, [] { return broken_dam(narrow); },
      [&](World& world) {
        const std::size_t count = world.particle_count();
        for (int k = 0; k < steps; ++k) world.step(frame);
        ids.assign(world.ids().begin(), world.ids().end());
        EXPECT_EQ(world.diagnostics().particles, count);
        std::vector<Vec3> places(world.positions().begin(), world.positions().end());
        EXPECT_EQ(places.size(), count);
        const auto less = [](Vec3 a, Vec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
        std::ranges::sort(places, less);
        EXPECT_EQ(std::ranges::adjacent_find(places), places.end());  // none was delivered twice
      });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
}

TEST(SharedWorld, RefusesByNameWhatItCannotHave) {
  const auto refuses = [](const std::string& named, const std::function<void(World&)>& change) {
    World world = broken_dam(narrow);
    change(world);
    const auto ranks = make_thread_ranks(1);
    expect_error(ErrorCode::invalid_argument, named, [&] { SharedWorld(world, *ranks[0]); });
    EXPECT_NO_THROW(world.step(frame));
  };
  refuses("needs WorldDef::sums = fixed for its bodies", [](World& world) {
    BodyDef body;
    body.pose.position = {0.3f, 2, 0.3f};
    world.create_body(body);
  });
  refuses("needs WorldDef::sums = fixed for its pressure grid", [](World& world) {
    WorldDef def = world.def();
    def.density.solver = DensitySolver::grid;
    world.set_def(def);
  });
  refuses("needs WorldDef::sums = fixed for its imposed emitters", [](World& world) {
    EmitterDef emitter;
    emitter.fluid = world.fluid_ids()[0];
    emitter.pose.position = {0.3f, 2, 0.3f};
    emitter.mode = EmitterMode::imposed;
    world.create_emitter(emitter);
  });
  refuses("no fluids with FluidDef::dynamic_viscosity", [](World& world) {
    FluidDef oil;
    oil.dynamic_viscosity = 1;
    world.create_fluid(oil);
  });
  refuses("no hooks", [](World& world) { world.add_hook(Hook::solved, [](const SubstepView&) {}); });
  refuses("no granular materials", [](World& world) { world.create_granular({}); });
  refuses("no ropes", [](World& world) {
    RopeDef rope;
    rope.points = {{0, 2, 0}, {0, 2.2f, 0}};
    world.create_rope(rope);
  });
  refuses("no force fields", [](World& world) {
    ForceFieldDef pull;
    pull.force = RadialForce{};
    world.create_force_field(pull);
  });
}

TEST(SharedWorld, RefusesByNameHowItCannotSolve) {
  const auto refuses = [](const std::string& named, const std::function<void(WorldDef&)>& change) {
    WorldDef def = world_def(pbd::DeviceKind::cpu, 0.05f);
    change(def);
    World world(def);
    const auto ranks = make_thread_ranks(1);
    expect_error(ErrorCode::invalid_argument, named, [&] { SharedWorld(world, *ranks[0]); });
  };
  refuses("no periodic axes", [](WorldDef& def) { def.periodic.x = PeriodicExtent{0, 2}; });
  refuses("no DensitySolverDef::tolerance", [](WorldDef& def) { def.density.tolerance = 0.01f; });
}

TEST(SharedWorld, GoesOnFromAFileAloneAndOnOtherRanks) {
  const std::string file = testing::TempDir() + "/shared.menisnap";
  uint64_t expected = 0;
  auto errors = share(
      3, restless_slabs, [] { return broken_dam(narrow); },
      [&](World& world) {
        tests::run(world, 5, frame);
        world.save(file);
        tests::run(world, 5, frame);
        expected = world.state_hash();
      });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
  World alone = World::load(file);
  tests::run(alone, 5, frame);
  EXPECT_EQ(alone.state_hash(), expected);
  errors = share(
      2, {}, [&] { return World::load(file); },
      [&](World& world) {
        tests::run(world, 5, frame);
        EXPECT_EQ(world.state_hash(), expected);
      });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
}

TEST(SharedWorld, EachRankReadsItsOwnParticles) {
  constexpr int count = 3;
  const auto ranks = make_thread_ranks(count);
  std::vector<ParticlesOfRank> own(count);
  std::map<ParticleId, std::tuple<Vec3, Vec3, float, float>> expected;
  const auto run = [&](int r) {
    World world = broken_dam(narrow);
    SharedWorld shared(world, *ranks[static_cast<size_t>(r)]);
    if (shared.leads()) {
      tests::run(world, 3, frame);
      for (size_t k = 0; k < world.ids().size(); ++k)
        expected[world.ids()[k]] = {world.positions()[k], world.velocities()[k], world.density_errors()[k],
                                    world.pressures()[k]};
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
    EXPECT_GT(p.ids.size(), 0u);
    found += p.ids.size();
    for (size_t k = 0; k < p.ids.size(); ++k) {
      const std::tuple mine{p.positions[k], p.velocities[k], p.density_errors[k], p.pressures[k]};
      EXPECT_TRUE(expected.at(p.ids[k]) == mine) << p.ids[k];
    }
  }
  EXPECT_EQ(found, expected.size());
}

TEST(SharedWorld, RefusesOtherCallsByName) {
  const auto errors = share(
      2, {}, [] { return broken_dam(narrow); },
      [](World& world) {
        expect_error(ErrorCode::invalid_argument, "create_fluid", [&] { world.create_fluid({}); });
        expect_error(ErrorCode::invalid_argument, "relax", [&] { world.relax(1); });
        expect_error(ErrorCode::invalid_argument, "snapshot", [&] { world.snapshot(); });
        EXPECT_NO_THROW(world.step(frame));
      });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
}

TEST(SharedWorld, NeedsThreeLayersARank) {
  const auto errors = share(
      8, slabs, [] { return broken_dam(narrow); }, [](World&) {});
  for (const std::string& error : errors)
    EXPECT_NE(error.find("8 ranks need 3 each"), std::string::npos) << error;
}

TEST(SharedWorld, AFailureOfOneRankEndsAll) {
  for (int call = 1; call < 40; call += 3)
    expect_failure_to_end_all([] { return broken_dam(narrow); }, call, 5);
}

}  // namespace
}  // namespace meniscus::tests
