// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Fluid and many bodies: the same calls give the same bits, and a step that has to be done again, or that
// fails, leaves no trace in the bodies.
#include <gtest/gtest.h>

#include <cstring>

#include "tests/coupling/body_worlds.h"
#include "tests/expect_error.h"
#include "tests/many_threads.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f, dt = 0.016f;

/// 48 bodies of four shapes over a pool, a gate on a driven hinge, and a kinematic paddle.
struct Crowd {
  World world;
  std::vector<BodyId> bodies;

  explicit Crowd(const WorldDef& def) : world(def) {
    world.create_shape(tank({0, 0, 0}, {1, 2, 0.8f}));
    for (int n = 0; n < 48; ++n) add_dropped(n);
    add_gate();
    BodyDef paddle = kinematic(BoxGeometry{{0.03f, 0.2f, 0.2f}}, {0.1f, 0.2f, 0.4f});
    paddle.keyframes = {{0, {{0.1f, 0.2f, 0.4f}, {0, 0, 0, 1}}},
                        {0.3f, {{0.3f, 0.2f, 0.4f}, about_z(20)}},
                        {0.6f, {{0.1f, 0.2f, 0.4f}, {0, 0, 0, 1}}}};
    paddle.loop = true;
    bodies.push_back(world.create_body(paddle));
    world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {1, 0.3f, 0.8f}));
  }

  std::vector<BodyState> states() const {
    std::vector<BodyState> all;
    for (BodyId id : bodies) all.push_back(world.body_state(id));
    return all;
  }

 private:
  void add_dropped(int n) {
    const Vec3 at{0.25f + 0.13f * float(n % 4), 0.5f + 0.13f * float(n / 16),
                  0.2f + 0.13f * float(n / 4 % 4)};
    const Geometry kinds[] = {
        BoxGeometry{{0.04f, 0.05f, 0.04f}}, SphereGeometry{0.05f}, CapsuleGeometry{0.03f, 0.03f},
        HullGeometry{{{0.05f, -0.04f, 0}, {-0.05f, -0.04f, 0.04f}, {-0.05f, -0.04f, -0.04f}, {0, 0.05f, 0}}}};
    BodyDef def = body(kinds[n % 4], at, n % 3 ? 600.0f : 2000.0f);
    def.surface.friction = 0.2f;
    def.angular_velocity = {float(n % 5), 1, float(n % 7)};
    bodies.push_back(world.create_body(def));
  }

  void add_gate() {
    const BodyId gate = world.create_body(body(BoxGeometry{{0.02f, 0.15f, 0.2f}}, {0.9f, 0.3f, 0.4f}, 400));
    bodies.push_back(gate);
    JointDef hinge;
    hinge.a = gate;
    hinge.frame = {{0.9f, 0.45f, 0.4f}, {0.70710678f, 0, 0, 0.70710678f}};
    hinge.kind = HingeJoint{{}, {}, 3, 5};
    world.create_joint(hinge);
  }
};

uint64_t hash_after(const WorldDef& def, int steps) {
  Crowd crowd(def);
  run(crowd.world, steps, dt);
  return crowd.world.state_hash();
}

void expect_same_bits(const std::vector<BodyState>& a, const std::vector<BodyState>& b) {
  const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  for (size_t n = 0; n < a.size(); ++n) {
    EXPECT_TRUE(same(a[n].pose, b[n].pose)) << "body " << n;
    EXPECT_TRUE(same(a[n].velocity, b[n].velocity)) << "body " << n;
    EXPECT_TRUE(same(a[n].angular_velocity, b[n].angular_velocity)) << "body " << n;
    EXPECT_EQ(a[n].awake, b[n].awake) << "body " << n;
  }
}

class BodyDeterminismTest : public OnDevice {};

TEST_P(BodyDeterminismTest, RunsAreAlike) {
  const WorldDef def = world_def(GetParam(), s);
  const uint64_t first = hash_after(def, 30);
  EXPECT_EQ(hash_after(def, 30), first);
}

TEST_P(BodyDeterminismTest, ReadOutsLeaveNoTrace) {
  const WorldDef def = world_def(GetParam(), s);
  Crowd watched(def);
  for (int k = 0; k < 20; ++k) {
    watched.world.step(dt);
    watched.states();
    watched.world.particle_contacts();
    watched.world.solid_contacts();
    watched.world.diagnostics();
    watched.world.cast_ray({0, 1, 0}, {1, 0, 1});
    watched.world.overlap_ball({0.5f, 0.3f, 0.4f}, 0.2f);
  }
  EXPECT_EQ(watched.world.state_hash(), hash_after(def, 20));
}

/// A bare pool into which, after a few steps, more bodies come than there was ever room for contacts with;
/// `roomy`, the same after those bodies had been there once before, and the world had seen to room for them.
/// Otherwise they had been above the pool. So the bodies have the same numbers, which Bullet's order follows.
uint64_t hash_with_sudden_bodies(const WorldDef& def, bool roomy) {
  World world(def);
  world.create_shape(tank({0, 0, 0}, {1, 2, 0.8f}));
  const FluidId water = world.create_fluid({});
  const std::vector<Vec3> pool = lattice(20, 8, 16, s, {0, 0, 0});
  const auto bodies_in = [&](float lift) {
    std::vector<BodyId> made;
    for (int n = 0; n < 60; ++n) {
      const Vec3 at{0.14f + 0.18f * float(n % 5), lift + 0.1f + 0.12f * float(n / 20),
                    0.13f + 0.18f * float(n / 5 % 4)};
      made.push_back(world.create_body(body(BoxGeometry{{0.06f, 0.045f, 0.06f}}, at, 700)));
    }
    return made;
  };
  // In both worlds, so that clocks and particles' numbers are the same.
  const ParticleId first = world.add_particles(water, pool);
  const std::vector<BodyId> made = bodies_in(roomy ? 0.0f : 1.0f);
  world.step(dt);
  for (BodyId id : made) world.destroy_body(id);
  std::vector<ParticleId> gone;
  for (ParticleId id = first; id < first + pool.size(); ++id) gone.push_back(id);
  world.remove_particles(gone);
  world.add_particles(water, pool);
  run(world, 2, dt);
  bodies_in(0);
  run(world, 5, dt);
  return world.state_hash();
}

TEST_P(BodyDeterminismTest, AStepDoneAgainForWantOfRoomIsTheSameStep) {
  const WorldDef def = world_def(GetParam(), s);
  EXPECT_EQ(hash_with_sudden_bodies(def, false), hash_with_sudden_bodies(def, true));
}

TEST_P(BodyDeterminismTest, AFailedStepLeavesTheBodiesBitForBit) {
  Crowd crowd(world_def(GetParam(), s)), twin(world_def(GetParam(), s));
  run(crowd.world, 15, dt);
  run(twin.world, 15, dt);
  const std::vector<BodyState> before = crowd.states();
  const uint64_t hash = crowd.world.state_hash();
  expect_error(ErrorCode::non_finite, "non-finite", [&] { crowd.world.step(1e20f); });
  EXPECT_EQ(crowd.world.state_hash(), hash);
  expect_same_bits(crowd.states(), before);
  run(crowd.world, 10, dt);
  run(twin.world, 10, dt);
  EXPECT_EQ(crowd.world.state_hash(), twin.world.state_hash());
}

TEST_P(BodyDeterminismTest, SoDoesAMadParticle) {
  Crowd crowd(world_def(GetParam(), s));
  run(crowd.world, 15, dt);
  const FluidId oil = crowd.world.create_fluid({});
  const std::vector<Vec3> at{{0.5f, 1.5f, 0.4f}}, velocity{{3e38f, 3e38f, 3e38f}};
  const std::vector<ParticleId> mad{crowd.world.add_particles(oil, at, velocity)};
  const std::vector<BodyState> before = crowd.states();
  const uint64_t hash = crowd.world.state_hash();
  expect_error(ErrorCode::non_finite, "non-finite", [&] { crowd.world.step(1000); });
  EXPECT_EQ(crowd.world.state_hash(), hash);
  expect_same_bits(crowd.states(), before);
  crowd.world.remove_particles(mad);
  run(crowd.world, 5, dt);
  EXPECT_EQ(crowd.world.diagnostics().non_finite, 0u);
}

MENISCUS_ON_EACH_DEVICE(BodyDeterminismTest);

TEST(CpuBodyDeterminism, TheNumberOfThreadsLeavesNoTrace) {
  const ManyThreads allowed;
  WorldDef def = world_def(pbd::DeviceKind::cpu, s);
  def.threads = 1;
  const uint64_t one = hash_after(def, 30);
  for (int threads : {2, 3, 8}) {
    def.threads = threads;
    EXPECT_EQ(hash_after(def, 30), one) << threads << " threads";
  }
}

}  // namespace
}  // namespace meniscus::tests
