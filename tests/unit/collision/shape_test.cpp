// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The analytic shapes against points strewn over their surfaces, and against slow integration of the kernel
// over their insides.
#include "collision/contact/shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "tests/unit/collision/mesh_shapes.h"

namespace meniscus::collision {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

struct KnownShape {
  const char* name;
  ShapeKind kind;
  Vec3 size;
  std::vector<Vec3> surface;         ///< in its own frame
  std::function<bool(Vec3)> inside;  ///< likewise
  float gap;                         ///< m: no surface point is farther from a strewn one
};

/// Over a square of side 2, as a grid.
std::vector<std::pair<float, float>> square(int n) {
  std::vector<std::pair<float, float>> points;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j)
      points.emplace_back(2 * float(i) / float(n) - 1, 2 * float(j) / float(n) - 1);
  }
  return points;
}

KnownShape known_box() {
  const Vec3 half{0.3f, 0.5f, 0.2f};
  KnownShape k{"box", ShapeKind::box, half, {}, {}, 0.015f};
  for (const auto& [u, v] : square(50)) {
    for (float side : {-1.0f, 1.0f}) {
      k.surface.push_back({side * half.x, u * half.y, v * half.z});
      k.surface.push_back({u * half.x, side * half.y, v * half.z});
      k.surface.push_back({u * half.x, v * half.y, side * half.z});
    }
  }
  k.inside = [=](Vec3 q) {
    return std::fabs(q.x) < half.x && std::fabs(q.y) < half.y && std::fabs(q.z) < half.z;
  };
  return k;
}

/// A ring of radius rho at height y.
void add_ring(std::vector<Vec3>& points, float rho, float y) {
  const int n = 1 + static_cast<int>(2 * pi * rho / 0.015f);
  for (int i = 0; i < n; ++i) {
    const float angle = 2 * pi * float(i) / float(n);
    points.push_back({rho * std::cos(angle), y, rho * std::sin(angle)});
  }
}

KnownShape known_capsule(float radius, float half_height, ShapeKind kind, const char* name) {
  KnownShape k{name, kind, {radius, half_height, 0}, {}, {}, 0.015f};
  for (int i = 0; i <= 80; ++i) {
    const float polar = pi * float(i) / 80, rise = radius * std::cos(polar);
    add_ring(k.surface, radius * std::sin(polar), rise + std::copysign(half_height, rise));
  }
  for (int i = 0; half_height > 0 && i <= 80; ++i) {
    add_ring(k.surface, radius, half_height * (float(i) / 40 - 1));
  }
  k.inside = [=](Vec3 q) {
    const float y = q.y - pbd::clamp(q.y, -half_height, half_height);
    return q.x * q.x + y * y + q.z * q.z < radius * radius;
  };
  return k;
}

KnownShape known_cylinder() {
  const float radius = 0.3f, half_height = 0.4f;
  KnownShape k{"cylinder", ShapeKind::cylinder, {radius, half_height, 0}, {}, {}, 0.015f};
  for (int i = 0; i <= 80; ++i) add_ring(k.surface, radius, half_height * (float(i) / 40 - 1));
  for (int i = 0; i <= 30; ++i) {
    add_ring(k.surface, radius * float(i) / 30, half_height);
    add_ring(k.surface, radius * float(i) / 30, -half_height);
  }
  k.inside = [=](Vec3 q) { return q.x * q.x + q.z * q.z < radius * radius && std::fabs(q.y) < half_height; };
  return k;
}

std::vector<KnownShape> known_shapes() {
  return {known_box(), known_capsule(0.4f, 0, ShapeKind::sphere, "sphere"),
          known_capsule(0.25f, 0.3f, ShapeKind::capsule, "capsule"), known_cylinder()};
}

Shape placed(const KnownShape& known) {
  Shape s;
  s.kind = known.kind;
  s.size = known.size;
  const float angle = 0.4f;
  const Vec3 axis = normalized_or({1, -2, 0.5f}, {0, 1, 0});
  s.pose = {{0.3f, -0.2f, 0.7f},
            {std::sin(angle) * axis.x, std::sin(angle) * axis.y, std::sin(angle) * axis.z, std::cos(angle)}};
  return s;
}

float nearest(const std::vector<Vec3>& points, Vec3 q) {
  float best = 3e38f;
  for (Vec3 p : points) best = std::min(best, length(p - q));
  return best;
}

TEST(Shape, TheDistanceIsThatOfTheNearestSurfacePoint) {
  for (const KnownShape& known : known_shapes()) {
    const Shape shape = placed(known);
    Noise noise(3);
    for (int n = 0; n < 300; ++n) {
      const Vec3 q = noise.in_cube(0.8f);
      const float distance = sample_surface({}, shape, to_world(shape.pose, q), 1).distance;
      const float strewn = nearest(known.surface, q);
      EXPECT_EQ(distance < 0, known.inside(q)) << known.name;
      EXPECT_LE(std::fabs(distance), strewn + 1e-5f) << known.name;
      EXPECT_GE(std::fabs(distance), strewn - known.gap) << known.name;
    }
  }
}

TEST(Shape, TheNormalIsTheGradientOfTheDistance) {
  for (const KnownShape& known : known_shapes()) {
    const Shape shape = placed(known);
    const auto distance = [&](Vec3 p) { return sample_surface({}, shape, p, 1).distance; };
    Noise noise(4);
    int smooth = 0;
    for (int n = 0; n < 500; ++n) {
      const Vec3 p = to_world(shape.pose, noise.in_cube(0.8f));
      const SurfaceSample s = sample_surface({}, shape, p, 1);
      EXPECT_NEAR(length(s.normal), 1, 1e-5f);
      const float e = 1e-3f;
      const Vec3 slope = Vec3{distance(p + Vec3{e, 0, 0}) - distance(p - Vec3{e, 0, 0}),
                              distance(p + Vec3{0, e, 0}) - distance(p - Vec3{0, e, 0}),
                              distance(p + Vec3{0, 0, e}) - distance(p - Vec3{0, 0, e})} /
                         (2 * e);
      if (std::fabs(length(slope) - 1) > 1e-3f) continue;  // across a ridge, of the inside
      ++smooth;
      EXPECT_LT(length(slope - s.normal), 0.02f) << known.name;
    }
    EXPECT_GT(smooth, 450) << known.name;
  }
}

TEST(Shape, AtPointsWithoutADirectionThereStillIsANormal) {
  for (const KnownShape& known : known_shapes()) {
    const Shape shape = placed(known);
    const SurfaceSample s = sample_surface({}, shape, shape.pose.position, 1);
    EXPECT_LT(s.distance, 0) << known.name;
    EXPECT_NEAR(length(s.normal), 1, 1e-5f) << known.name;
  }
}

TEST(Shape, APlaneIsAHalfSpace) {
  Shape plane;
  plane.size = normalized_or({1, 2, -2}, {0, 1, 0});
  plane.offset = 0.5f;
  const SurfaceSample s = sample_surface({}, plane, {3, 0, 0}, 1);
  EXPECT_NEAR(s.distance, 0.5f, 1e-6f);
  EXPECT_EQ(s.normal, plane.size);
  EXPECT_EQ(solid_fraction({}, plane, {3, 0, 0}, s.distance, 1), 1);
}

/// ∫ W_poly6 over the solid, around the point q of its frame.
double kernel_inside(const KnownShape& known, Vec3 q, float h) {
  const int n = 40;
  double inside = 0, all = 0;
  for (int i = 0; i < n * n * n; ++i) {
    const Vec3 d =
        h * (2.0f / float(n) * Vec3{float(i % n) + 0.5f, float(i / n % n) + 0.5f, float(i / n / n) + 0.5f} -
             Vec3{1, 1, 1});
    const double u = h * h - dot(d, d);
    if (u <= 0) continue;
    all += u * u * u;
    if (known.inside(q + d)) inside += u * u * u;
  }
  return inside / all;
}

// Beside an edge the product of the faces' shares is an approximation.
TEST(Shape, TheFractionFillsTheKernelAsTheSolidDoes) {
  const float h = 0.1f;
  for (const KnownShape& known : known_shapes()) {
    const Shape shape = placed(known);
    Noise noise(5);
    int seen = 0;
    while (seen < 60) {
      const Vec3 q = noise.in_cube(0.7f);
      const Vec3 p = to_world(shape.pose, q);
      const float distance = sample_surface({}, shape, p, h).distance;
      if (distance < 0 || distance > 0.6f * h) continue;
      ++seen;
      const float found = solid_fraction({}, shape, p, distance, h) * pbd::half_space_density(distance / h);
      EXPECT_NEAR(found, kernel_inside(known, q, h), 0.035) << known.name << " at " << distance / h << " h";
    }
  }
}

TEST(Shape, AThinBoxFillsLittle) {
  Shape sheet;
  sheet.kind = ShapeKind::box;
  sheet.size = {1, 0.005f, 1};
  const float h = 0.1f;
  const float fraction = solid_fraction({}, sheet, {0, 0.025f, 0}, 0.02f, h);
  const float expected = pbd::half_space_density(0.2f) - pbd::half_space_density(0.3f);
  EXPECT_NEAR(fraction * pbd::half_space_density(0.2f), expected, 1e-3f);
}

}  // namespace
}  // namespace meniscus::collision
