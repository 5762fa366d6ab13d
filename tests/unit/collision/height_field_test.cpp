// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the distance to height fields.
#include "collision/contact/height_field.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/unit/collision/mesh_shapes.h"

namespace meniscus::collision {
namespace {

constexpr uint32_t columns = 9, rows = 7;
constexpr float cell_size = 0.25f;
constexpr float half_x = 1.0f, half_z = 0.75f;

// Hills a cell high: each sample at random.
struct Hills {
  std::vector<float> heights;
  HeightFieldView view{};

  Hills() {
    Noise noise(17);
    for (uint32_t i = 0; i < columns * rows; ++i) heights.push_back(0.3f * noise.next());
    view = {columns, rows, cell_size, {heights.data(), columns * rows}};
  }
};

float brute_distance(const HeightFieldView& field, Vec3 p) {
  float nearest = 3e38f;
  for (uint32_t j = 0; j + 1 < field.rows; ++j) {
    for (uint32_t i = 0; i + 1 < field.columns; ++i) {
      for (bool second : {false, true}) {
        nearest =
            std::min(nearest, length(offset_to_triangle(height_field_triangle(field, i, j, second), p)));
      }
    }
  }
  return nearest;
}

TEST(HeightField, HeightsAreLinearOnEachTriangle) {
  const Hills hills;
  Noise noise(1);
  for (int n = 0; n < 500; ++n) {
    const Vec3 c = noise.in_cube(1);
    const Vec3 p{half_x * c.x, 0, half_z * c.z};
    const Vec3 on_surface{p.x, height_at(hills.view, p), p.z};
    EXPECT_LT(brute_distance(hills.view, on_surface), 1e-6f);
  }
  EXPECT_FLOAT_EQ(height_at(hills.view, {-half_x, 0, -half_z}), hills.heights.front());
  EXPECT_FLOAT_EQ(height_at(hills.view, {half_x, 0, half_z}), hills.heights.back());
}

TEST(HeightField, OverTheFieldTheDistanceIsThatOfAllTriangles) {
  const Hills hills;
  const float reach = 0.4f;
  Noise noise(2);
  int near = 0;
  for (int n = 0; n < 3000; ++n) {
    const Vec3 c = noise.in_cube(1);
    const Vec3 p{half_x * c.x, c.y, half_z * c.z};
    const float exact = brute_distance(hills.view, p), side = p.y < height_at(hills.view, p) ? -1.0f : 1.0f;
    const SurfaceSample sample = sample_height_field(hills.view, p, reach);
    EXPECT_NEAR(sample.distance, side * std::min(exact, reach), 1e-5f);
    EXPECT_NEAR(length(sample.normal), 1, 1e-5f);
    if (exact > 0.01f && exact < reach) {
      ++near;
      EXPECT_LT(brute_distance(hills.view, p - sample.distance * sample.normal), 1e-5f);
      EXPECT_GT(sample.normal.y, -1e-5f);
    }
  }
  EXPECT_GT(near, 1000);
}

TEST(HeightField, OnTheSurfaceTheNormalIsTheTriangles) {
  const Hills hills;
  Noise noise(3);
  for (int n = 0; n < 200; ++n) {
    const Triangle t = height_field_triangle(hills.view, n % (columns - 1), n / columns % (rows - 1), n % 2);
    const float u = 0.1f + 0.4f * noise.next(), v = 0.1f + 0.4f * noise.next();
    const Vec3 p = t.a + u * (t.b - t.a) + v * (t.c - t.a);
    const SurfaceSample sample = sample_height_field(hills.view, p, 0.3f);
    EXPECT_NEAR(sample.distance, 0, 1e-6f);
    EXPECT_GT(dot(sample.normal, normalized_or(area_normal(t), {0, 0, 0})), 0.9999f);
  }
}

TEST(HeightField, BeyondTheBorderThereIsACliff) {
  const Hills hills;
  const SurfaceSample below = sample_height_field(hills.view, {half_x + 0.1f, -1, 0}, 0.5f);
  EXPECT_NEAR(below.distance, 0.1f, 1e-6f);
  EXPECT_NEAR(below.normal.x, 1, 1e-6f);
  const SurfaceSample corner = sample_height_field(hills.view, {-half_x - 0.3f, -1, -half_z - 0.4f}, 0.2f);
  EXPECT_NEAR(corner.distance, 0.5f, 1e-6f);
  Noise noise(4);
  for (int n = 0; n < 500; ++n) {
    const Vec3 p{half_x + 0.3f * noise.next(), 0.31f + 0.2f * noise.next(), half_z * (2 * noise.next() - 1)};
    EXPECT_NEAR(sample_height_field(hills.view, p, 1).distance, brute_distance(hills.view, p), 1e-5f);
  }
}

TEST(HeightField, BeyondTheBorderTheDistanceIsContinuousAndPositive) {
  const Hills hills;
  Noise noise(5);
  for (int n = 0; n < 500; ++n) {
    const Vec3 p{half_x + 0.2f * noise.next(), 0.4f * noise.next() - 0.05f, half_z * (2 * noise.next() - 1)};
    const Vec3 q = p + noise.in_cube(1e-3f);
    if (!(p.x > half_x && q.x > half_x)) continue;
    const float a = sample_height_field(hills.view, p, 1).distance,
                b = sample_height_field(hills.view, q, 1).distance;
    EXPECT_GT(a, 0);
    EXPECT_LE(std::fabs(a - b), length(p - q) + 1e-5f);
  }
}

TEST(HeightField, TheSmallestFieldIsTwoTriangles) {
  const std::vector<float> heights{1, 1, 1, 1};
  const HeightFieldView flat{2, 2, 2.0f, {heights.data(), 4}};
  EXPECT_FLOAT_EQ(sample_height_field(flat, {0.3f, 1.5f, -0.9f}, 1).distance, 0.5f);
  EXPECT_FLOAT_EQ(sample_height_field(flat, {0.3f, 0.5f, -0.9f}, 1).distance, -0.5f);
  EXPECT_FLOAT_EQ(sample_height_field(flat, {0.3f, -9, -0.9f}, 1).distance, -1);
  EXPECT_FLOAT_EQ(sample_height_field(flat, {0.3f, 99, -0.9f}, 1).distance, 1);
}

}  // namespace
}  // namespace meniscus::collision
