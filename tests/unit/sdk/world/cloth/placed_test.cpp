// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth that is placed into a solid leaves it slowly, and does not burst.
#include <gtest/gtest.h>

#include <functional>

#include "tests/cloth_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float thickness = 0.008f, exit_distance = 0.5f * thickness / 0.02f;  // m/s

struct Place {
  const char* name;
  Geometry geometry;
  float height;                         ///< of the sheet, above the solid's origin, m
  float max_stretch;                    ///< at any time
  std::function<float(Vec3)> distance;  ///< from the solid, m
};

float from_box(Vec3 x, float half) {
  const Vec3 d = abs(x) - Vec3{half, half, half};
  return std::min(max_component(d), 0.0f) + length(max(d, Vec3{0, 0, 0}));
}

const Place floors[] = {{"OnAFloor", PlaneGeometry{}, 0, 1.01f, [](Vec3 x) { return x.y; }},
                        {"BelowAFloor", PlaneGeometry{}, -0.05f, 1.01f, [](Vec3 x) { return x.y; }}};
const Place solids[] = {
    {"InABall", SphereGeometry{0.3f}, 0.2f, 1.15f, [](Vec3 x) { return length(x) - 0.3f; }},
    {"InABox", BoxGeometry{{0.3f, 0.3f, 0.3f}}, 0.27f, 1.2f, [](Vec3 x) { return from_box(x, 0.3f); }},
    {"ThroughABox", BoxGeometry{{0.3f, 0.3f, 0.3f}}, 0, 1.2f, [](Vec3 x) { return from_box(x, 0.3f); }}};

class PlacedCloth : public OnDevice {
 protected:
  struct Found {
    float fastest = 0, max_stretch = 0;  ///< at any time
    float least = 0;                     ///< distance in the end, m
  };

  World world_with(int substeps) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.substeps = substeps;
    return World(def);
  }

  Found watch(World& world, const Place& place, int steps) {
    ClothDef def = sheet(1, 1, 33, 33, {0, place.height, 0});
    def.fabric.thickness = thickness;
    const ClothId id = world.create_cloth(def);
    Found found;
    for (int k = 0; k < steps; ++k) {
      world.step(1 / 60.0f);
      for (Vec3 v : world.cloth_velocities(id)) found.fastest = std::max(found.fastest, length(v));
      found.max_stretch = std::max(found.max_stretch, world.cloth_state(id).max_stretch);
    }
    found.least = 1;
    for (Vec3 x : world.cloth_positions(id)) found.least = std::min(found.least, place.distance(x));
    return found;
  }
};
MENISCUS_ON_EACH_DEVICE(PlacedCloth);

TEST_P(PlacedCloth, RisesFromAFloor) {
  for (const Place& place : floors) {
    for (int substeps : {4, 16}) {
      World world = world_with(substeps);
      world.create_shape(shape(place.geometry));
      const Found found = watch(world, place, 30);
      EXPECT_LT(found.fastest, 1.5f * exit_distance) << place.name << ' ' << substeps;
      EXPECT_LT(found.max_stretch, place.max_stretch) << place.name << ' ' << substeps;
      EXPECT_GT(found.least, 0.4f * thickness) << place.name << ' ' << substeps;
    }
  }
}

// What lies beside the solid falls, and swings; in free fall it would come to 3.3 m/s.
TEST_P(PlacedCloth, DoesNotBurst) {
  for (const Place& place : solids) {
    for (int substeps : {4, 16}) {
      World world = world_with(substeps);
      world.create_shape(shape(place.geometry));
      const Found found = watch(world, place, 20);
      EXPECT_LT(found.fastest, 4) << place.name << ' ' << substeps;
      EXPECT_LT(found.max_stretch, place.max_stretch) << place.name << ' ' << substeps;
    }
  }
}

TEST_P(PlacedCloth, DoesNotBurstOutOfBodies) {
  for (const Place& place : solids) {
    for (BodyMotion motion : {BodyMotion::kinematic, BodyMotion::dynamic}) {
      World world = world_with(8);
      world.create_shape(shape(PlaneGeometry{}, {0, -0.3f, 0}));
      BodyDef body;
      body.geometry = place.geometry;
      body.motion = motion;
      world.create_body(body);
      const Found found = watch(world, place, 20);
      EXPECT_LT(found.fastest, 4) << place.name << ' ' << static_cast<int>(motion);
      EXPECT_LT(found.max_stretch, place.max_stretch) << place.name << ' ' << static_cast<int>(motion);
    }
  }
}

TEST_P(PlacedCloth, ComesOutOfABall) {
  World world = world_with(8);
  world.create_shape(shape(solids[0].geometry));
  EXPECT_GT(watch(world, solids[0], 40).least, 0.4f * thickness);
}

// Through a face, with no vertex in it. Cloth that comes later, and looks in between, are all the same to it.
TEST_P(PlacedCloth, DoesNotBurstOfARodThroughAFace) {
  World world = world_with(4);
  world.create_shape(shape(CapsuleGeometry{0.04f, 0.3f}, {0.06f, 0.5f, 0.06f}));
  const ClothId id = world.create_cloth(sheet(0.8f, 0.8f, 5, 5, {0, 0.5f, 0}));
  world.diagnostics();
  world.create_cloth(sheet(0.8f, 0.8f, 5, 5, {4, 0.5f, 4}));
  float fastest = 0;
  for (int k = 0; k < 30; ++k) {
    world.step(1 / 60.0f);
    for (Vec3 v : world.cloth_velocities(id)) fastest = std::max(fastest, length(v));
  }
  EXPECT_LT(fastest, 5);
}

TEST_P(PlacedCloth, RopesLikewise) {
  World world = world_with(16);
  world.create_shape(shape(PlaneGeometry{}));
  RopeDef def = rope({{0, -0.02f, 0}, {1, -0.02f, 0}}, 20);
  def.radius = 0.01f;
  const RopeId id = world.create_rope(def);
  float fastest = 0;
  for (int k = 0; k < 30; ++k) {
    world.step(1 / 60.0f);
    for (Vec3 v : world.rope_velocities(id)) fastest = std::max(fastest, length(v));
  }
  EXPECT_LT(fastest, 1.5f * def.radius / 0.02f);
  for (Vec3 x : world.rope_positions(id)) EXPECT_GT(x.y, 0.8f * def.radius);
}

}  // namespace
}  // namespace meniscus::tests
