// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Friction and restitution of a single particle, where textbook formulas hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f, radius = 0.5f * s;
constexpr float gravity = 9.81f;
constexpr float degree = 3.14159265f / 180;

class FrictionTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), s)};
  FluidId fluid_ = world_.create_fluid({});

  void add(Vec3 position, Vec3 velocity = {0, 0, 0}) {
    world_.add_particles(fluid_, std::vector<Vec3>{position}, std::vector<Vec3>{velocity});
  }
  Vec3 position() const { return world_.positions()[0]; }
  Vec3 velocity() const { return world_.velocities()[0]; }

  ShapeDef plane(Vec3 normal, float friction, float restitution = 0) const {
    ShapeDef def = shape(PlaneGeometry{normal, 0});
    def.surface.friction = friction;
    def.surface.restitution = restitution;
    return def;
  }

  /// How far a particle slides within a second down an incline of this angle.
  float slide(float angle, float friction) {
    const Vec3 normal{std::sin(angle), std::cos(angle), 0};
    world_.create_shape(plane(normal, friction));
    add(radius * normal);
    run(world_, 10, 0.01f);
    const Vec3 start = position(), v = velocity();
    run(world_, 100, 0.01f);
    return length(position() - start) - length(v);
  }
};

constexpr float mu = 0.5f;
const float critical = std::atan(mu);

TEST_P(FrictionTest, BelowTheCriticalAngleItSticks) {
  EXPECT_LT(slide(critical - degree, mu), 0.002f);
}

TEST_P(FrictionTest, AboveTheCriticalAngleItSlides) {
  const float angle = critical + degree;
  const float expected = 0.5f * gravity * (std::sin(angle) - mu * std::cos(angle));
  EXPECT_NEAR(slide(angle, mu), expected, 0.1f * expected);
}

TEST_P(FrictionTest, WithoutFrictionItSlidesFreely) {
  const float angle = 20 * degree, expected = 0.5f * gravity * std::sin(angle);
  EXPECT_NEAR(slide(angle, 0), expected, 0.02f * expected);
}

TEST_P(FrictionTest, TheStoppingDistanceIsTheTextbooks) {
  world_.create_shape(plane({0, 1, 0}, 0.4f));
  add({0, radius, 0}, {2, 0, 0});
  run(world_, 100, 0.01f);
  EXPECT_NEAR(position().x, 2 * 2 / (2 * 0.4f * gravity), 0.02f);
  EXPECT_LT(length(velocity()), 1e-3f);
}

// Velocities change at a substep's start, so that a particle moves half a substep less than it should.
TEST_P(FrictionTest, TheStoppingDistanceLacksHalfASubstep) {
  for (int substeps : {4, 16}) {
    for (float friction : {0.3f, 0.5f, 0.7f}) {
      constexpr float speed = 2, frame = 1 / 60.0f;
      WorldDef def = world_def(GetParam(), s);
      def.substeps = substeps;
      World world(def);
      world.create_shape(plane({0, 1, 0}, friction));
      world.add_particles(world.create_fluid({}), std::vector<Vec3>{{0, radius, 0}},
                          std::vector<Vec3>{{speed, 0, 0}});
      run(world, 60, frame);
      const float exact = speed * speed / (2 * friction * gravity);
      const float lack = 0.5f * speed * frame / static_cast<float>(substeps);
      EXPECT_NEAR(world.positions()[0].x, exact - lack, 1e-3f * exact)
          << "μ " << friction << ", " << substeps;
    }
  }
}

TEST_P(FrictionTest, ItDoesNotDependOnTheSubsteps) {
  float stopped[2];
  for (int k = 0; k < 2; ++k) {
    WorldDef def = world_def(GetParam(), s);
    def.substeps = k ? 16 : 2;
    World world(def);
    world.create_shape(plane({0, 1, 0}, 0.4f));
    world.add_particles(world.create_fluid({}), std::vector<Vec3>{{0, radius, 0}},
                        std::vector<Vec3>{{2, 0, 0}});
    run(world, 100, 0.01f);
    stopped[k] = world.positions()[0].x;
  }
  EXPECT_NEAR(stopped[0] / stopped[1], 1, 0.05);
}

class RestitutionTest : public FrictionTest {
 protected:
  /// The greatest height above the resting one, after the first touch of a fall from a metre.
  float bounce(const ShapeDef& floor) {
    world_.create_shape(floor);
    add({0, 1 + radius, 0});
    bool touched = false;
    float height = 0;
    for (int k = 0; k < 110; ++k) {
      world_.step(0.01f);
      touched |= velocity().y > 0 || position().y < 1.1f * radius;
      if (touched) height = std::max(height, position().y - radius);
    }
    return height;
  }
};

TEST_P(RestitutionTest, ItBouncesToTheSquare) {
  for (float e : {0.3f, 0.6f, 0.9f}) {
    world_ = World(world_def(GetParam(), s));
    fluid_ = world_.create_fluid({});
    EXPECT_NEAR(bounce(plane({0, 1, 0}, 0, e)), e * e, 0.03f) << "restitution " << e;
  }
}

TEST_P(RestitutionTest, OnABoxToo) {
  ShapeDef box = shape(BoxGeometry{{1, 0.01f, 1}}, {0, -0.01f, 0});
  box.surface.restitution = 0.6f;
  EXPECT_NEAR(bounce(box), 0.36f, 0.03f);
}

TEST_P(RestitutionTest, WithoutItThereIsNoBounce) {
  EXPECT_LT(bounce(plane({0, 1, 0}, 0, 0)), 0.1f * radius);  // as near as touching starts to count
}

TEST_P(RestitutionTest, ARestingContactDoesNotBounce) {
  world_.create_shape(plane({0, 1, 0}, 0, 0.9f));
  add({0, radius, 0});
  for (int k = 0; k < 50; ++k) {
    world_.step(0.01f);
    EXPECT_LT(std::fabs(velocity().y), 0.02f);
    EXPECT_NEAR(position().y, radius, 0.02f * radius);
  }
}

TEST_P(RestitutionTest, ItComesToRestInTheEnd) {
  world_.create_shape(plane({0, 1, 0}, 0, 0.5f));
  add({0, 0.5f, 0});
  run(world_, 300, 0.01f);
  EXPECT_LT(std::fabs(velocity().y), 0.01f);
}

MENISCUS_ON_EACH_DEVICE(FrictionTest);
MENISCUS_ON_EACH_DEVICE(RestitutionTest);

}  // namespace
}  // namespace meniscus::tests
