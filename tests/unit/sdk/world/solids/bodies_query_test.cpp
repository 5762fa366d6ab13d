// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rays and overlaps, among bodies, fixed shapes and particles.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

/// From left to right along x: a fixed box from −1 to 0, a body's box from 1 to 2, a particle at 3.
class BodyQueryTest : public OnDevice {
 protected:
  static constexpr float s = 0.05f;
  World world_{weightless(GetParam(), s)};
  ShapeId wall_ = world_.create_shape(shape(BoxGeometry{}, {-0.5f, 0, 0}));
  BodyId crate_ = world_.create_body(body(BoxGeometry{}, {1.5f, 0, 0}));
  FluidId water_ = world_.create_fluid({});
  ParticleId drop_ = world_.add_particles(water_, std::vector<Vec3>{{3, 0, 0}});

  RayHit hit(Vec3 from, Vec3 to) {
    const std::optional<RayHit> found = world_.cast_ray(from, to);
    EXPECT_TRUE(found.has_value());
    return found.value_or(RayHit{});
  }
  void expect_wall(const RayHit& found) {
    EXPECT_EQ(found.shape, wall_);
    EXPECT_EQ(found.body, BodyId{});
    EXPECT_FALSE(found.particle.has_value());
  }
  void expect_crate(const RayHit& found) {
    EXPECT_EQ(found.body, crate_);
    EXPECT_EQ(found.shape, ShapeId{});
    EXPECT_FALSE(found.particle.has_value());
  }
  void expect_drop(const RayHit& found) {
    EXPECT_EQ(found.particle, std::optional(drop_));
    EXPECT_EQ(found.body, BodyId{});
    EXPECT_EQ(found.shape, ShapeId{});
  }
  static void expect_at(const RayHit& found, Vec3 point, Vec3 normal, float distance) {
    expect_near(found.point, point, 1e-4f);
    expect_near(found.normal, normal, 1e-4f);
    EXPECT_NEAR(found.distance, distance, 1e-4f);
  }
};

TEST_P(BodyQueryTest, ARayFromAfarMeetsWhatLiesOnIt) {
  for (int k = 0; k < 100; ++k) {
    const float a = 0.06f * static_cast<float>(k), slope = 0.3f + 0.002f * static_cast<float>(k);
    const Vec3 centre{3, 0, 0};
    const Vec3 away =
        300.0f * Vec3{std::sin(slope), std::cos(slope) * std::cos(a), std::cos(slope) * std::sin(a)};
    const Vec3 side{0, -1.5f * s * std::sin(a), 1.5f * s * std::cos(a)};  // three radii
    expect_drop(hit(centre + away, centre - away));
    EXPECT_FALSE(world_.cast_ray(centre + side + away, centre + side - away).has_value()) << k;
  }
}

TEST_P(BodyQueryTest, ARayFindsTheNearestOfAllKinds) {
  const RayHit from_left = hit({-5, 0.2f, 0.1f}, {5, 0.2f, 0.1f});
  expect_wall(from_left);
  expect_at(from_left, {-1, 0.2f, 0.1f}, {-1, 0, 0}, 4);
  const RayHit from_between = hit({0.5f, 0, 0}, {5, 0, 0});
  expect_crate(from_between);
  expect_at(from_between, {1, 0, 0}, {-1, 0, 0}, 0.5f);
  const RayHit from_right = hit({5, 0, 0}, {-5, 0, 0});
  expect_drop(from_right);
  expect_at(from_right, {3 + s / 2, 0, 0}, {1, 0, 0}, 2 - s / 2);
}

TEST_P(BodyQueryTest, ARayHasAnEnd) {
  EXPECT_FALSE(world_.cast_ray({0.2f, 0, 0}, {0.9f, 0, 0}).has_value());
  EXPECT_FALSE(world_.cast_ray({2.2f, 0, 0}, {2.9f, 0, 0}).has_value());
  EXPECT_FALSE(world_.cast_ray({2.2f, 0, 0}, {2.2f, 0, 0}).has_value());
  EXPECT_FALSE(world_.cast_ray({5, 3, 0}, {-5, 3, 0}).has_value());
  EXPECT_FALSE(world_.cast_ray({5, 0.51f * s, 0}, {2.5f, 0.51f * s, 0}).has_value());
  expect_drop(hit({5, 0.49f * s, 0}, {2.5f, 0.49f * s, 0}));
}

TEST_P(BodyQueryTest, ARayMeetsABodyWhereItIsNow) {
  world_.set_body_pose(crate_, {{1.5f, 7, 0}});
  expect_drop(hit({0.5f, 0, 0}, {5, 0, 0}));
  expect_crate(hit({0.5f, 7, 0}, {5, 7, 0}));
  world_.set_body_velocity(crate_, {0, -7, 0}, {0, 0, 0});
  run(world_, 100, 0.01f);
  expect_crate(hit({0.5f, 0, 0}, {5, 0, 0}));
}

TEST_P(BodyQueryTest, WhatIsGoneIsNotMet) {
  world_.destroy_body(crate_);
  world_.destroy_shape(wall_);
  expect_drop(hit({-5, 0, 0}, {5, 0, 0}));
  world_.remove_particles(world_.ids());
  EXPECT_FALSE(world_.cast_ray({-5, 0, 0}, {5, 0, 0}).has_value());
}

TEST_P(BodyQueryTest, RaysMeetEachGeometry) {
  TemporaryFolder folder;
  MeshGeometry brick{folder.write("brick.obj", brick_obj)};
  brick.scale = 0.5f;
  CompoundGeometry compound;
  compound.parts.push_back({BoxGeometry{{0.25f, 0.25f, 0.25f}}, {{-0.25f, 0.2f, 0.2f}}});
  std::vector<Vec3> corners;
  for (int c = 0; c < 8; ++c) corners.push_back({c & 1 ? 0.5f : -0.5f, c & 2 ? 0.5f : 0, c & 4 ? 0.5f : 0});
  struct Case {
    Geometry geometry;
    float x;  ///< where a ray along +x at y = z = 0.2 meets it
  };
  const float round = -std::sqrt(0.25f - 2 * 0.04f), across = -std::sqrt(0.25f - 0.04f);
  for (const Case& c : {Case{SphereGeometry{0.5f}, round}, Case{CapsuleGeometry{0.5f, 0.5f}, across},
                        Case{CylinderGeometry{0.5f, 0.5f}, across}, Case{brick, 0}, Case{compound, -0.5f},
                        Case{HullGeometry{corners}, -0.5f}}) {
    for (BodyMotion motion : {BodyMotion::dynamic, BodyMotion::kinematic}) {
      BodyDef def = body(c.geometry, {0, 50, 0});
      def.motion = motion;
      const BodyId id = world_.create_body(def);
      const RayHit found = hit({-3, 50.2f, 0.2f}, {3, 50.2f, 0.2f});
      EXPECT_EQ(found.body, id) << c.geometry.index();
      EXPECT_NEAR(found.point.x, c.x, 2e-3f) << c.geometry.index();
      world_.destroy_body(id);
    }
  }
}

TEST_P(BodyQueryTest, ABallOverlapsWhatItReaches) {
  Overlaps found = world_.overlap_ball({0.5f, 0, 0}, 0.49f);
  EXPECT_TRUE(found.bodies.empty() && found.shapes.empty() && found.particles.empty());
  found = world_.overlap_ball({0.5f, 0, 0}, 0.51f);
  EXPECT_EQ(found.bodies, std::vector{crate_});
  EXPECT_EQ(found.shapes, std::vector{wall_});
  EXPECT_TRUE(found.particles.empty());
  found = world_.overlap_ball({2.5f, 0, 0}, 0.51f);
  EXPECT_EQ(found.bodies, std::vector{crate_});
  EXPECT_TRUE(found.shapes.empty());
  EXPECT_EQ(found.particles, std::vector{drop_});
  EXPECT_EQ(world_.overlap_ball({1.5f, 0, 0}, 0.01f).bodies, std::vector{crate_});  // within it
}

TEST_P(BodyQueryTest, ABoxOverlapsWhatItReachesAlsoWhenItIsTurned) {
  const Vec3 slim{0.6f, 0.05f, 0.05f};
  EXPECT_EQ(world_.overlap_box({{0.5f, 0, 0}}, slim).bodies, std::vector{crate_});
  EXPECT_EQ(world_.overlap_box({{0.5f, 0, 0}}, slim).shapes, std::vector{wall_});
  const Overlaps upright = world_.overlap_box({{0.5f, 0, 0}, about_z(90)}, slim);
  EXPECT_TRUE(upright.bodies.empty() && upright.shapes.empty());
  EXPECT_EQ(world_.overlap_box({{3, 0.5f, 0}, about_z(90)}, slim).particles, std::vector{drop_});
  EXPECT_TRUE(world_.overlap_box({{3, 0.5f, 0}}, slim).particles.empty());
}

TEST_P(BodyQueryTest, OverlapsAreInTheOrderOfTheIds) {
  std::vector<BodyId> bodies{crate_};
  for (int k = 0; k < 8; ++k)
    bodies.push_back(world_.create_body(body(SphereGeometry{0.2f}, {1.5f, 0.3f * float(k % 3), 0.7f})));
  world_.add_particles(water_, lattice(4, 4, 4, s, {1.4f, 0, 0.6f}));
  const Overlaps found = world_.overlap_ball({1.5f, 0, 0.6f}, 0.5f);
  EXPECT_EQ(found.bodies, bodies);
  EXPECT_EQ(found.particles.size(), 64u);
  EXPECT_TRUE(std::is_sorted(found.particles.begin(), found.particles.end()));
}

MENISCUS_ON_EACH_DEVICE(BodyQueryTest);

}  // namespace
}  // namespace meniscus::tests
