// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the nearest point of a face to a solid.
#include "collision/body/face_points_nearest.h"

#include <gtest/gtest.h>

#include <random>

namespace meniscus::tests {
namespace {

using collision::FaceField;
using collision::FaceMotion;
using collision::FaceSample;
using collision::Shape;
using collision::ShapeKind;
using collision::ShapeSet;
using collision::Triangle;

constexpr float reach = 10, tolerance = 1e-4f;

struct Solid {
  const char* name;
  ShapeKind kind;
  Vec3 size;
};

const Solid solids[] = {{"box", ShapeKind::box, {0.3f, 0.2f, 0.4f}},
                        {"needle", ShapeKind::box, {0.01f, 0.6f, 0.01f}},
                        {"plate", ShapeKind::box, {0.5f, 0.005f, 0.5f}},
                        {"sphere", ShapeKind::sphere, {0.15f, 0, 0}},
                        {"thin capsule", ShapeKind::capsule, {0.02f, 0.5f, 0}},
                        {"cylinder", ShapeKind::cylinder, {0.2f, 0.3f, 0}}};

Shape shape_of(const Solid& solid) {
  Shape shape;
  shape.kind = solid.kind;
  shape.size = solid.size;
  return shape;
}

Vec3 random_in(std::mt19937& random, float half) {
  std::uniform_real_distribution<float> range(-half, half);
  const float x = range(random), y = range(random), z = range(random);
  return {x, y, z};
}

/// The least distance over a fine lattice of the triangle's points.
float least_of_many(const FaceField& field, const Triangle& t) {
  constexpr int n = 120;
  float least = 1e30f;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      const float u = static_cast<float>(i) / n, v = static_cast<float>(j) / n;
      least = std::min(least, field.at(t, {u, v, 1 - u - v}).surface.distance);
    }
  }
  return least;
}

TEST(FaceNearest, IsTheLeastDistanceOverTheFaceForAllKinds) {
  std::mt19937 random(7);
  for (const Solid& solid : solids) {
    const Shape shape = shape_of(solid);
    const ShapeSet set;
    const FaceField field{set, shape, reach};
    float worst = 0;
    for (int k = 0; k < 300; ++k) {
      const Vec3 centre = random_in(random, 0.6f);
      const Triangle t{centre + random_in(random, 0.4f), centre + random_in(random, 0.4f),
                       centre + random_in(random, 0.4f)};
      const FaceSample found = field.nearest(t, tolerance);
      const Vec3 w = found.weights;
      ASSERT_GE(std::min({w.x, w.y, w.z}), 0);
      ASSERT_NEAR(w.x + w.y + w.z, 1, 1e-6f);
      ASSERT_FLOAT_EQ(found.surface.distance, field.at(t, w).surface.distance);
      const float least = least_of_many(field, t);
      // Where both overlap, deep is enough; where they do not, nearest is wanted.
      const float excess = found.surface.distance - least;
      if (least > 0) worst = std::max(worst, excess);
      if (least < -0.002f) {
        EXPECT_LT(found.surface.distance, 2 * tolerance) << solid.name << ' ' << k << " depth " << -least;
      }
    }
    EXPECT_LT(worst, 0.002f) << solid.name;
  }
}

/// It slides along for tens of steps before it goes in, and ends on the other side.
TEST(FaceNearest, ALongWayIntoAThinPlateMeetsItsNearSide) {
  constexpr float touch = 5e-4f;
  const Shape plate = shape_of(solids[2]);
  const ShapeSet set;
  const FaceField field{set, plate, reach};
  const Vec3 from{-0.4f, 0.005f + 1.5f * touch, 0}, to{0.4f, -0.005f - 2 * touch, 0};
  const Triangle face{{0, 0, 0}, {0.01f, 0, 0}, {0, 0, 0.01f}};
  const auto at = [&](Vec3 p) { return Triangle{face.a + p, face.b + p, face.c + p}; };
  const collision::FaceMeeting met = meet_face(field, FaceMotion{at(from), at(to)}, touch);
  EXPECT_GT(met.sample.surface.normal.y, 0.99f);
  EXPECT_LT(met.sample.surface.distance, touch);
  EXPECT_GT(met.sample.surface.distance, 0);
}

}  // namespace
}  // namespace meniscus::tests
