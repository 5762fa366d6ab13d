// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of density maps against quadrature and closed forms.
#include "collision/sdf/density_map.h"

#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "collision/sdf/density_map_quadrature.h"
#include "pbd/device/cpu/cpu_device.h"
#include "pbd/math/half_space.h"
#include "tests/unit/collision/solid_shapes.h"

namespace meniscus::collision {
namespace {

constexpr float h = 0.1f;
const Vec3 offset{0.013f, 0.007f, -0.011f};  // of solids against the lattice's origin

struct Double3 {
  double x, y, z;
};

// ∫ (a − z²)³ dz from 0.
double column(double a, double z) {
  const double zz = z * z;
  return z * (a * a * a + zz * (-a * a + zz * (0.6 * a - zz / 7)));
}

// ∫ W over a box, seen from its kernel's centre, for h = 1: by columns, each in closed form.
double box_integral(Double3 lower, Double3 upper) {
  constexpr int n = 100;
  const double x0 = std::max(lower.x, -1.0), x1 = std::min(upper.x, 1.0);
  double sum = 0;
  for (int i = 0; i < n && x0 < x1; ++i) {
    const double x = x0 + (x1 - x0) * (i + 0.5) / n, reach = std::sqrt(1 - x * x);
    const double y0 = std::max(lower.y, -reach), y1 = std::min(upper.y, reach);
    for (int j = 0; j < n && y0 < y1; ++j) {
      const double y = y0 + (y1 - y0) * (j + 0.5) / n, a = std::max(0.0, 1 - x * x - y * y);
      const double z0 = std::max(lower.z, -std::sqrt(a)), z1 = std::min(upper.z, std::sqrt(a));
      if (z0 < z1) sum += (x1 - x0) * (y1 - y0) / (n * n) * (column(a, z1) - column(a, z0));
    }
  }
  return 315 / (64 * std::numbers::pi) * sum;
}

double box_density(const Aabb& box, Vec3 p) {
  const auto seen = [&](Vec3 v) {
    return Double3{(double{v.x} - p.x) / h, (double{v.y} - p.y) / h, (double{v.z} - p.z) / h};
  };
  return box_integral(seen(box.lower), seen(box.upper));
}

Sdf build(pbd::CpuDevice& device, const TriangleMesh& mesh, float cell_size) {
  const DeviceTriangleBvh tree(device, TriangleBvh(mesh));
  Sdf sdf = build_sdf(device, tree, cell_size, h);
  build_density_map(device, tree, sdf, h);
  return sdf;
}

// Along a line from `start` through the surface, a support radius and more to both sides.
template <class Exact>
double largest_error(const Sdf& sdf, Vec3 start, Vec3 way, const Exact& exact) {
  double error = 0;
  for (int i = -24; i <= 24; ++i) {
    const Vec3 p = start + (static_cast<float>(i) / 20 * h) * way + Vec3{0.0031f, 0.0017f, 0.0023f};
    error = std::max(error, std::fabs(sample_density(sdf.view(), p).density - exact(p)));
  }
  return error;
}

const float diagonal = std::sqrt(0.5f), space_diagonal = std::sqrt(1.0f / 3);

TEST(DensityQuadrature, WeightsAddUpAndSlopesSeeASlope) {
  for (float cells : {0.5f, 1.0f, 3.0f, 4.0f, 8.0f, 11.0f, 40.0f}) {
    const DensityQuadrature q = density_quadrature(h / cells, h, 100);
    double sum = 0, slope = 0;
    for (const QuadraturePoint& p : q.points) {
      sum += p.weight;
      slope += static_cast<double>(p.slope) * p.x * (p.x * q.step);
      EXPECT_LE(q.step * std::sqrt(static_cast<float>(p.x * p.x + p.y * p.y + p.z * p.z)), h);
    }
    EXPECT_NEAR(sum, 1, 1e-5) << cells;
    EXPECT_NEAR(slope, 1, 1e-5) << cells;
    EXPECT_NEAR(q.step * static_cast<float>(q.refinement), h / cells, 1e-6f);
    const float spacing = q.step * static_cast<float>(q.stride);
    if (cells < 1) continue;
    EXPECT_GT(spacing, 0.124f * h) << cells;
    EXPECT_LT(spacing, 0.251f * h) << cells;
  }
}

TEST(DensityQuadrature, CellsAreDividedAsOftenAsAllowed) {
  EXPECT_EQ(density_quadrature(h / 4, h, 100).refinement, 2u);
  EXPECT_EQ(density_quadrature(h / 4, h, 100).stride, 2u);
  EXPECT_EQ(density_quadrature(h / 4, h, 1).refinement, 1u);
  EXPECT_EQ(density_quadrature(h / 4, h, 0).stride, 1u);
  EXPECT_EQ(density_quadrature(h / 8, h, 100).refinement, 1u);
  EXPECT_EQ(density_quadrature(h, h, 100).refinement, 8u);
  EXPECT_EQ(density_quadrature(3 * h, h, 100).refinement, 8u);
}

TEST(DensityMap, AFlatFaceIsAHalfSpace) {
  pbd::CpuDevice device;
  const Quat turns[] = {{0, 0, 0, 1},
                        {0, 0, std::sin(0.3926991f), std::cos(0.3926991f)},
                        {0.18257419f, 0.36514837f, 0.54772256f, 0.73029674f}};
  for (const Quat turn : turns) {
    const Pose pose{offset, turn};
    const TriangleMesh box = placed(box_mesh({-0.15f, -0.15f, -0.1f}, {0.15f, 0.15f, 0.2f}), pose);
    for (float cells : {4.0f, 7.0f, 12.0f}) {
      const Sdf sdf = build(device, box, h / cells);
      for (float x = -1.2f; x <= 1.2f; x += 0.01f) {
        const Vec3 p = to_world(pose, {0.0031f, 0.0017f, 0.2f + x * h});
        const DensitySample sample = sample_density(sdf.view(), p);
        ASSERT_NEAR(sample.density, pbd::half_space_density(x), cells < 5 ? 0.003f : 0.002f)
            << cells << ' ' << x;
        const float a = std::max(0.0f, 1 - x * x), slope = -315.0f / 256 * a * a * a * a;
        const Vec3 exact = slope * rotate(turn, {0, 0, 1});
        ASSERT_LT(length(h * sample.gradient - exact), 0.12f) << cells << ' ' << x;
      }
    }
  }
}

TEST(DensityMap, EdgesAndCornersOfABoxAgreeWithQuadrature) {
  pbd::CpuDevice device;
  const Aabb box{offset - Vec3{0.25f, 0.25f, 0.25f}, offset + Vec3{0.25f, 0.25f, 0.25f}};
  const auto exact = [&](Vec3 p) { return box_density(box, p); };
  const Vec3 edge{box.upper.x, box.upper.y, offset.z};
  for (float cells : {4.0f, 5.0f, 8.0f, 12.0f}) {
    const Sdf sdf = build(device, box_mesh(box.lower, box.upper), h / cells);
    const double bound = cells < 8 ? 0.01 : 0.007;
    EXPECT_LT(largest_error(sdf, edge, {diagonal, diagonal, 0}, exact), bound) << cells;
    EXPECT_LT(largest_error(sdf, edge, {0, 1, 0}, exact), bound) << cells;
    EXPECT_LT(largest_error(sdf, box.upper, {space_diagonal, space_diagonal, space_diagonal}, exact), bound)
        << cells;
  }
}

TEST(DensityMap, InnerCornersOfACupAgreeWithQuadrature) {
  pbd::CpuDevice device;
  const float half = 0.3f, wall = 0.12f, inner = half - wall;
  const auto exact = [&](Vec3 p) {
    return box_density({{-half, 0, -half}, {half, 2 * half, half}}, p) -
           box_density({{-inner, wall, -inner}, {inner, 2 * half, inner}}, p);
  };
  for (float cells : {4.0f, 8.0f}) {
    const Sdf sdf = build(device, cup_mesh(half, wall), h / cells);
    const double bound = cells < 8 ? 0.01 : 0.007;
    EXPECT_LT(largest_error(sdf, {inner, 0.35f, inner}, {diagonal, 0, diagonal}, exact), bound) << cells;
    EXPECT_LT(
        largest_error(sdf, {inner, wall, inner}, {space_diagonal, -space_diagonal, space_diagonal}, exact),
        bound)
        << cells;
  }
}

TEST(DensityMap, AThinPlateFillsLittle) {
  pbd::CpuDevice device;
  for (float cells : {4.0f, 6.0f, 8.0f, 12.0f}) {
    const double bound = cells < 8 ? 0.01 : 0.007;
    const float thickness = 2 * h / cells;
    const Vec3 half{0.25f, 0.25f, 0.5f * thickness};
    const Aabb plate{offset - half, offset + half};
    const auto exact = [&](Vec3 p) { return box_density(plate, p); };
    const Sdf sdf = build(device, box_mesh(plate.lower, plate.upper), h / cells);
    EXPECT_LT(largest_error(sdf, offset, {0, 0, 1}, exact), bound) << cells;
    EXPECT_LT(largest_error(sdf, {plate.upper.x, offset.y, offset.z}, {1, 0, 0}, exact), bound) << cells;
  }
}

// A ball without its cap is filled up to the membrane, from which half of the kernel is solid.
TEST(DensityMap, AClosedHoleIsAFace) {
  pbd::CpuDevice device;
  const Sdf sdf = build(device, open_ball_mesh(0.5f, 4, 0.3f), h / 4);
  float y = 0.2f;
  while (sample_sdf(sdf.view(), {0, y, 0}).distance < 0) y += 0.001f;
  EXPECT_NEAR(sample_density(sdf.view(), {0, y, 0}).density, 0.5f, 0.05f);
  EXPECT_EQ(sample_density(sdf.view(), {0, y - 1.5f * h, 0}).density, 1);
  EXPECT_EQ(sample_density(sdf.view(), {0, y + 1.5f * h, 0}).density, 0);
}

TEST(DensityMap, WithFewerSamplesItIsOffByLittle) {
  pbd::CpuDevice device;
  const Aabb box{offset - Vec3{0.25f, 0.25f, 0.25f}, offset + Vec3{0.25f, 0.25f, 0.25f}};
  const auto exact = [&](Vec3 p) { return box_density(box, p); };
  const DeviceTriangleBvh tree(device, TriangleBvh(box_mesh(box.lower, box.upper)));
  Sdf sdf = build_sdf(device, tree, h / 4, h);
  build_density_map(device, tree, sdf, h, sdf.nodes().count());  // one for each node
  const double face = largest_error(sdf, {box.upper.x, offset.y, offset.z}, {1, 0, 0}, exact);
  const double edge =
      largest_error(sdf, {box.upper.x, box.upper.y, offset.z}, {diagonal, diagonal, 0}, exact);
  EXPECT_LT(face, 0.003);
  EXPECT_LT(edge, 0.015);
}

TEST(DensityMap, BeyondTheGridThereIsNothing) {
  pbd::CpuDevice device;
  const Sdf sdf = build(device, box_mesh({-0.2f, -0.2f, -0.2f}, {0.2f, 0.2f, 0.2f}), h / 4);
  for (Vec3 p : {Vec3{1, 0, 0}, Vec3{0, -5, 0}, Vec3{std::nanf(""), 0, 0}}) {
    const DensitySample sample = sample_density(sdf.view(), p);
    EXPECT_EQ(sample.density, 0);
    EXPECT_EQ(length(sample.gradient), 0);
  }
}

TEST(DensityMap, ThreadsDoNotChangeABit) {
  pbd::CpuDevice one(1), two(2);
  const Sdf a = build(one, ball_mesh(0.15f, 2), h / 9), b = build(two, ball_mesh(0.15f, 2), h / 9);
  const std::vector<pbd::Vec4> in_a = a.density().read(a.nodes().count()),
                               in_b = b.density().read(b.nodes().count());
  EXPECT_TRUE(std::equal(in_a.begin(), in_a.end(), in_b.begin(), [](const pbd::Vec4& x, const pbd::Vec4& y) {
    return x.xyz() == y.xyz() && x.w == y.w;
  }));
}

TEST(DensityMap, BadSupportRadiiAreRefused) {
  pbd::CpuDevice device;
  const DeviceTriangleBvh tree(device, TriangleBvh(box_mesh({0, 0, 0}, {0.2f, 0.2f, 0.2f})));
  Sdf sdf = build_sdf(device, tree, h / 4, h);
  for (float bad : {0.0f, -1.0f, std::nanf(""), HUGE_VALF})
    EXPECT_THROW(build_density_map(device, tree, sdf, bad), Error);
  EXPECT_EQ(sdf.view().density.count, 0u);
}

}  // namespace
}  // namespace meniscus::collision
