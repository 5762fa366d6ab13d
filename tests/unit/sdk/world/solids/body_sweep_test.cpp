// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Thin bodies that move fast among particles: none may pass through.
#include <gtest/gtest.h>

#include "tests/rigid_solvers.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f, dt = 0.01f;

class BodySweepTest : public WithSolver {
 protected:
  World world_{weightless(GetParam(), s)};

  /// n × n particles around the x axis, too far apart to meet; n is odd.
  static std::vector<Vec3> sheet(float x, int n = 7) {
    std::vector<Vec3> points;
    for (int k = 0; k < n * n; ++k)
      points.push_back({x, 0.11f * float(k % n - n / 2), 0.11f * float(k / n - n / 2)});
    return points;
  }
  void add(const std::vector<Vec3>& points, Vec3 velocity = {0, 0, 0}) {
    world_.add_particles(world_.create_fluid({}), points, std::vector<Vec3>(points.size(), velocity));
  }
};

// Up to 10 cm a substep, a plate of 1 cm.
TEST_P(BodySweepTest, APlateTakesParticlesAlong) {
  for (float speed : {1.0f, 5.0f, 20.0f, 40.0f}) {
    world_ = World(weightless(GetParam(), s));
    add(sheet(0));
    const BodyId plate = world_.create_body(kinematic(BoxGeometry{{0.005f, 0.5f, 0.5f}}, {-0.5f, 0, 0}));
    world_.move_body(plate, {{0.5f, 0, 0}}, 1 / speed);
    run(world_, static_cast<int>(1.0f / speed / dt) + 2, dt);
    for (Vec3 p : world_.positions()) EXPECT_GT(p.x, 0.5f) << speed;
  }
}

TEST_P(BodySweepTest, ParticlesThatComeTheOtherWayAreStoppedToo) {
  add(sheet(0.6f), {-20, 0, 0});
  const BodyId plate = world_.create_body(kinematic(BoxGeometry{{0.005f, 0.5f, 0.5f}}, {-0.5f, 0, 0}));
  world_.move_body(plate, {{0.5f, 0, 0}}, 0.05f);
  for (int k = 0; k < 10; ++k) {
    world_.step(dt);
    const float x = world_.body_state(plate).pose.position.x;
    for (Vec3 p : world_.positions()) ASSERT_GT(p.x, x) << k;
  }
}

// Up to 30 cm a substep, which is more than a contact reaches.
TEST_P(BodySweepTest, ManySmallPlatesTakeAParticleEachAlong) {
  const std::vector<Vec3> points = sheet(0, 21);
  std::vector<BodyId> plates;
  for (size_t k = 0; k < points.size(); ++k) {
    BodyDef def = body(BoxGeometry{{0.005f, 0.03f, 0.03f}}, points[k] - Vec3{0.5f + 0.001f * float(k), 0, 0});
    def.velocity = {20 + 100 * float(k % 2), 0, 0};
    def.density = 20000;
    plates.push_back(world_.create_body(def));
  }
  add(points);
  for (int k = 0; k < 8; ++k) {
    world_.step(dt);
    const std::span<const Vec3> at = world_.positions();
    for (size_t n = 0; n < plates.size(); ++n)
      ASSERT_GT(at[n].x, world_.body_state(plates[n]).pose.position.x) << k << ' ' << n;
  }
  for (Vec3 p : world_.positions()) EXPECT_GT(p.x, 0.1f);
}

// The blade's tip goes at 19 m/s, 4.7 cm a substep; a quarter turn in 0.05 s.
TEST_P(BodySweepTest, ABladeThatTurnsSweepsItsSector) {
  std::vector<Vec3> sector;
  for (int n = 0; n < 40; ++n) {
    const float r = 0.15f + 0.1f * float(n % 5), angle = (20 + 7.0f * float(n / 5)) * pi / 180;
    sector.push_back({r * std::cos(angle), r * std::sin(angle), 0.0f});
  }
  add(sector);
  CompoundGeometry blade;
  blade.parts.push_back({BoxGeometry{{0.3f, 0.005f, 0.3f}}, {{0.3f, 0, 0}}});
  const BodyId id = world_.create_body(kinematic(blade));
  world_.move_body(id, {{0, 0, 0}, about_z(90)}, 0.05f);
  for (int k = 1; k <= 5; ++k) {
    world_.step(dt);
    const float angle = float(k) * 18 * pi / 180;
    const Vec3 ahead{-std::sin(angle), std::cos(angle), 0};
    for (Vec3 p : world_.positions()) {
      if (length(p) < 0.6f) {  // others have been flung off its tip
        ASSERT_GT(dot(ahead, p), 0) << k;
      }
    }
  }
}

TEST_P(BodySweepTest, AFallingPlateIsHeldByNoParticleAndPassesNone) {
  const BodyId plate = [&] {
    BodyDef def = body(BoxGeometry{{0.5f, 0.005f, 0.5f}}, {0, 0.5f, 0});
    def.velocity = {0, -20, 0};
    def.density = 8000;
    return world_.create_body(def);
  }();
  std::vector<Vec3> level;
  for (Vec3 p : sheet(0)) level.push_back({p.y, 0, p.z});
  add(level);
  for (int k = 0; k < 10; ++k) {
    world_.step(dt);
    const float y = world_.body_state(plate).pose.position.y;
    if (y > 0.1f) continue;
    for (Vec3 p : world_.positions()) ASSERT_LT(p.y, y + 0.005f) << k;
  }
  EXPECT_LT(world_.body_state(plate).pose.position.y, -0.3f);
}

// Bullet turns the plate back after the particles' solve, which saw it go on.
TEST_P(BodySweepTest, APlateThatBouncesOffTakesThoseBehindItBack) {
  if (GetParam().solver == RigidSolver::device) GTEST_SKIP() << "particles get into the plate by half";
  ShapeDef stop = shape(BoxGeometry{{0.2f, 0.1f, 0.5f}}, {0.3f, 0.9f, 0});  // at its rim; from x = 0.1 on
  stop.surface.solid_restitution = 1;
  world_.create_shape(stop);
  stop.pose.position.y = -0.9f;
  world_.create_shape(stop);
  BodyDef def = body(BoxGeometry{{0.005f, 1, 0.5f}}, {-0.2f, 0, 0});
  def.velocity = {20, 0, 0};
  def.density = 8000;
  def.surface.solid_restitution = 1;
  const BodyId plate = world_.create_body(def);
  add(sheet(-0.26f), {20, 0, 0});
  bool turned = false;
  for (int k = 0; k < 10; ++k) {
    world_.step(dt);
    const BodyState state = world_.body_state(plate);
    turned |= state.velocity.x < -5;
    for (Vec3 p : world_.positions()) ASSERT_LT(p.x, state.pose.position.x) << k;
    ASSERT_EQ(world_.diagnostics().outside, 0u) << k;
  }
  EXPECT_TRUE(turned);
}

MENISCUS_WITH_EACH_RIGID_SOLVER(BodySweepTest);

}  // namespace
}  // namespace meniscus::tests
