// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rays, overlaps and the nearest place: solids, particles, cloth and ropes.
#include <random>

#include "sdk/world/queries/geometry.h"
#include "tests/cloth_worlds.h"
#include "tests/expect_error.h"
#include "tests/unit/sdk/world/extension/force_worlds.h"

namespace meniscus::tests {
namespace {

class QueriesTest : public OnDevice {};

/// A floor, a particle above it, cloth above that, and a rope above all.
struct Layers {
  World world;
  ShapeId floor;
  BodyId body;
  ClothId cloth;
  RopeId cord;

  explicit Layers(pbd::DeviceKind kind) : world(world_def(kind, 0.1f)) {
    const FluidId water = world.create_fluid({});
    floor = world.create_shape(shape(PlaneGeometry{}, {0, 0, 0}));
    world.add_particles(water, std::vector<Vec3>{{0, 0.5f, 0}});
    cloth = world.create_cloth(sheet(1, 1, 5, 5, {0, 1, 0}));
    RopeDef thick = rope({{-1, 2, 0}, {1, 2, 0}}, 4);
    thick.radius = 0.1f;
    cord = world.create_rope(thick);
    BodyDef ball;
    ball.geometry = SphereGeometry{0.25f};
    ball.pose.position = {3, 1, 0};
    body = world.create_body(ball);
  }
};

QueryTargets only(bool QueryTargets::*kind) {
  QueryTargets targets{false, false, false, false};
  targets.*kind = true;
  return targets;
}

TEST_P(QueriesTest, ARayMeetsEachKindInOrder) {
  Layers l(GetParam());
  QueryTargets targets;
  const Vec3 from{0.01f, 5, 0.02f}, to{0.01f, -1, 0.02f};
  std::optional<RayHit> hit = l.world.cast_ray(from, to, targets);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->rope, l.cord);
  EXPECT_EQ(hit->element, 2u);
  EXPECT_NEAR(hit->point.y, 2 + std::sqrt(0.01f - 0.0004f), 1e-5f);
  EXPECT_NEAR(hit->distance, 5 - hit->point.y, 1e-5f);
  EXPECT_NEAR(hit->normal.z, 0.2f, 1e-4f);
  targets.ropes = false;
  hit = l.world.cast_ray(from, to, targets);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->cloth, l.cloth);
  EXPECT_NEAR(hit->point.y, 1, 1e-6f);
  EXPECT_NEAR(hit->normal.y, 1, 1e-6f);
  const std::span<const uint32_t> triangles = l.world.cloth_triangles(l.cloth);
  ASSERT_LT(hit->element, triangles.size() / 3);
  Vec3 middle{0, 0, 0};
  for (uint32_t k = 0; k < 3; ++k)
    middle += l.world.cloth_positions(l.cloth)[triangles[3 * hit->element + k]] / 3.0f;
  EXPECT_LT(length(middle - hit->point), 0.25f);
  targets.cloth = false;
  hit = l.world.cast_ray(from, to, targets);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->particle, ParticleId{0});
  targets.particles = false;
  hit = l.world.cast_ray(from, to, targets);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->shape, l.floor);
  targets.solids = false;
  EXPECT_FALSE(l.world.cast_ray(from, to, targets));
}

TEST_P(QueriesTest, ClothIsMetFromBelowToo) {
  Layers l(GetParam());
  const std::optional<RayHit> hit =
      l.world.cast_ray({0.3f, 0.6f, 0.1f}, {0.3f, 1.4f, 0.1f}, only(&QueryTargets::cloth));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->normal.y, -1, 1e-6f);
  EXPECT_NEAR(hit->distance, 0.4f, 1e-6f);
}

TEST_P(QueriesTest, TheNearestOfEachKindIsFound) {
  Layers l(GetParam());
  const auto nearest = [&](Vec3 p, bool QueryTargets::*kind) { return l.world.nearest(p, 10, only(kind)); };
  auto place = nearest({0, 1.3f, 0.1f}, &QueryTargets::solids);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->shape, l.floor);
  EXPECT_NEAR(place->distance, 1.3f, 1e-5f);
  expect_near(place->point, {0, 0, 0.1f}, 1e-5f);
  place = nearest({3, 2, 0}, &QueryTargets::solids);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->body, l.body);
  EXPECT_NEAR(place->distance, 0.75f, 1e-5f);
  place = nearest({0.1f, 0.5f, 0}, &QueryTargets::particles);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->particle, ParticleId{0});
  EXPECT_NEAR(place->distance, 0.05f, 1e-6f);
  place = nearest({0.8f, 1.4f, 0}, &QueryTargets::cloth);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->cloth, l.cloth);
  EXPECT_NEAR(place->distance, 0.5f, 1e-5f) << "at the border";
  expect_near(place->normal, {0.6f, 0.8f, 0}, 1e-4f);
  place = nearest({1.4f, 2, 0}, &QueryTargets::ropes);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->rope, l.cord);
  EXPECT_EQ(place->element, 3u);
  EXPECT_NEAR(place->distance, 0.3f, 1e-5f);
  place = l.world.nearest({0, 1.7f, 0}, 10);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->rope, l.cord);
  EXPECT_FALSE(l.world.nearest({0, 1.7f, 0}, 0.1f));
  place = l.world.nearest({3, 1.1f, 0}, 1);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->distance, -0.15f, 1e-5f) << "inside a body";
}

TEST_P(QueriesTest, VolumesOverlapClothAndRopes) {
  Layers l(GetParam());
  Overlaps found = l.world.overlap_ball({0.1f, 1.2f, 0.1f}, 0.21f);
  EXPECT_EQ(found.cloths, std::vector<ClothId>{l.cloth});
  EXPECT_TRUE(found.ropes.empty() && found.shapes.empty() && found.particles.empty());
  EXPECT_TRUE(l.world.overlap_ball({0.1f, 1.2f, 0.1f}, 0.19f).cloths.empty());
  found = l.world.overlap_ball({0, 2.5f, 0}, 0.41f);
  EXPECT_EQ(found.ropes, std::vector<RopeId>{l.cord});
  EXPECT_TRUE(l.world.overlap_ball({0, 2.5f, 0}, 0.39f).ropes.empty());
  const Pose turned{{0, 0.9f, 0}, about_z(45)};
  found = l.world.overlap_box(turned, {0.08f, 0.08f, 0.08f});
  EXPECT_EQ(found.cloths, std::vector<ClothId>{l.cloth}) << "its edge reaches 0.113 m up";
  EXPECT_TRUE(l.world.overlap_box(turned, {0.07f, 0.07f, 0.07f}).cloths.empty());
  found = l.world.overlap_box({{0, 1.5f, 0}, {0, 0, 0, 1}}, {0.1f, 2, 0.1f});
  EXPECT_EQ(found.particles.size(), 1u);
  EXPECT_EQ(found.ropes.size() + found.cloths.size() + found.shapes.size(), 3u);
  found = l.world.overlap_box({{0, 1.5f, 0}, {0, 0, 0, 1}}, {0.1f, 2, 0.1f}, only(&QueryTargets::particles));
  EXPECT_EQ(found.particles.size(), 1u);
  EXPECT_TRUE(found.ropes.empty() && found.cloths.empty() && found.shapes.empty());
}

TEST_P(QueriesTest, AreInTheFrameOfTheUser) {
  WorldDef def = world_def(GetParam(), 0.1f);
  def.origin = {1000, 0, 0};
  World world(def);
  const ClothId cloth = world.create_cloth(sheet(1, 1, 5, 5, {1000, 1, 0}));
  const auto place = world.nearest({1000, 1.5f, 0}, 1);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->cloth, cloth);
  expect_near(place->point, {1000, 1, 0}, 1e-3f);
}

TEST_P(QueriesTest, RefuseBadArguments) {
  Layers l(GetParam());
  expect_error(ErrorCode::invalid_argument, "nearest's reach", [&] { l.world.nearest({0, 0, 0}, 0); });
  expect_error(ErrorCode::invalid_argument, "nearest's point", [&] { l.world.nearest({NAN, 0, 0}, 1); });
  expect_error(ErrorCode::invalid_argument, "sample_fluid", [&] {
    l.world.sample_fluid(std::vector<Vec3>{{NAN, 0, 0}});
  });
}

/// A point of a block: the density of a lattice at rest, and the mean of the velocities.
TEST_P(QueriesTest, TheFluidIsSampledAsProbesDo) {
  WorldDef def = world_def(GetParam(), 0.05f);
  def.substeps = 1;
  World world = dam_break(def);
  const Vec3 inside{0.22f, 0.31f, 0.24f};
  ProbeDef density, velocity;
  density.kind = ProbeKind::point_density;
  velocity.kind = ProbeKind::point_velocity;
  density.point = velocity.point = inside;
  const ProbeId a = world.create_probe(density), b = world.create_probe(velocity);
  const FluidSample before = world.sample_fluid(std::vector<Vec3>{{0.25f, 0.25f, 0.25f}})[0];
  EXPECT_NEAR(before.density, 1000, 40) << "a lattice at rest, between its points";
  run(world, 5, 0.01f);
  const std::vector<FluidSample> found = world.sample_fluid(std::vector<Vec3>{inside, {0.9f, 0.9f, 0.25f}});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].density, world.probe(a), 1e-3 * world.probe(a));
  expect_near(found[0].velocity, world.probe_vector(b), 1e-3f * length(found[0].velocity));
  EXPECT_GT(found[0].particles, 20u);
  EXPECT_EQ(found[1].particles, 0u);
  EXPECT_EQ(found[1].density, 0);
}

TEST_P(QueriesTest, OneFluidIsSampledAlone) {
  World world(world_def(GetParam(), 0.1f));
  FluidDef oil;
  oil.name = "oil";
  oil.rest_density = 500;
  const FluidId a = world.create_fluid({}), b = world.create_fluid(oil);
  world.add_particles(a, std::vector<Vec3>{{0, 0, 0}}, std::vector<Vec3>{{1, 0, 0}});
  world.add_particles(b, std::vector<Vec3>{{0, 0, 0.1f}}, std::vector<Vec3>{{0, 2, 0}});
  const std::vector<Vec3> between{{0, 0, 0.05f}};
  const FluidSample both = world.sample_fluid(between)[0], one = world.sample_fluid(between, a)[0],
                    other = world.sample_fluid(between, b)[0];
  EXPECT_EQ(both.particles, 2u);
  EXPECT_EQ(one.particles, 1u);
  expect_near(one.velocity, {1, 0, 0}, 1e-6f);
  expect_near(other.velocity, {0, 2, 0}, 1e-6f);
  expect_near(both.velocity, {0.5f, 1, 0}, 1e-6f);
  EXPECT_NEAR(one.density, 2 * other.density, 1e-3f * one.density);
  EXPECT_NEAR(both.density, one.density + other.density, 1e-3f * one.density);
}

MENISCUS_ON_EACH_DEVICE(QueriesTest);

/// Against brute force over points of the segment, and of the triangle.
TEST(QueryGeometry, BoxesAgreeWithSamples) {
  std::mt19937 random(5);
  const Vec3 half{0.3f, 0.5f, 0.4f};
  const auto outside = [&](Vec3 p) { return length(max(abs(p) - half, Vec3{0, 0, 0})); };
  int met = 0;
  for (int k = 0; k < 300; ++k) {
    const Vec3 a = random_vector(random, 1), b = random_vector(random, 1), c = random_vector(random, 1);
    float segment = 10, triangle = 10;
    for (int i = 0; i <= 60; ++i) {
      segment = std::min(segment, outside(a + float(i) / 60 * (b - a)));
      for (int j = 0; j <= 60 - i; ++j)
        triangle = std::min(triangle, outside(a + float(i) / 60 * (b - a) + float(j) / 60 * (c - a)));
    }
    constexpr float near = 0.02f;
    const bool overlaps = queries::overlaps_box(half, a, b, c),
               is_near = queries::comes_near_box(half, a, b, 0.2f);
    if (overlaps) {
      EXPECT_LT(triangle, near) << k;
    } else {
      EXPECT_GT(triangle, 0) << k;
    }
    met += triangle == 0;
    if (!is_near) {
      EXPECT_GT(segment, 0.2f) << k;
    }
    if (is_near) {
      EXPECT_LT(segment, 0.2f + near) << k;
    }
  }
  EXPECT_GT(met, 50);
}

}  // namespace
}  // namespace meniscus::tests
