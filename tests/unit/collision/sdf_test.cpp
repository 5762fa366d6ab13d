// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the signed distance field of a mesh.
#include <gtest/gtest.h>
#include <meniscus/error.h>

#include "collision/mesh/triangle_bvh_query.h"
#include "collision/sdf/build.h"
#include "collision/sdf/sdf_error.h"
#include "pbd/device/cpu/cpu_device.h"
#include "tests/unit/collision/solid_shapes.h"

namespace meniscus::collision {
namespace {

struct BuiltSdf {
  TriangleBvh bvh;
  Sdf sdf;
};

BuiltSdf build(pbd::CpuDevice& device, const TriangleMesh& mesh, float cell_size, float margin) {
  TriangleBvh bvh(mesh);
  const DeviceTriangleBvh copy(device, bvh);
  return {std::move(bvh), build_sdf(device, copy, cell_size, margin)};
}

float largest_step(const Sdf& sdf) {
  const Lattice& n = sdf.nodes();
  const std::vector<float> d = sdf.values().read(n.count());
  float step = 0;
  for (uint32_t k = 1; k < n.nz; ++k) {
    for (uint32_t j = 1; j < n.ny; ++j) {
      for (uint32_t i = 1; i < n.nx; ++i) {
        const float here = d[n.index(i, j, k)];
        step =
            std::max({step, std::fabs(here - d[n.index(i - 1, j, k)]),
                      std::fabs(here - d[n.index(i, j - 1, k)]), std::fabs(here - d[n.index(i, j, k - 1)])});
      }
    }
  }
  return step;
}

TEST(Sdf, ABallComesNearTheSphere) {
  pbd::CpuDevice device;
  const BuiltSdf ball = build(device, ball_mesh(1, 4), 0.06f, 0.3f);
  Noise noise(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = noise.in_cube(1.2f);
    const float exact = length(p) - 1;
    const SurfaceSample sample = sample_sdf(ball.sdf.view(), p);
    EXPECT_NEAR(sample.distance, exact, 0.01f + (length(p) < 0.1f ? 0.05f : 0));
    EXPECT_NEAR(length(sample.normal), 1, 1e-5f);
    if (length(p) < 0.3f) continue;  // where the normals meet
    EXPECT_GT(dot(sample.normal, p) / length(p), 0.985f);
  }
}

/// Along an axis the interpolated distance is linear within a cell, so difference quotients are exact there.
TEST(Sdf, NormalsAreTheSlopeOfTheInterpolatedDistance) {
  pbd::CpuDevice device;
  const float cell = 0.2f, step = 0.1f * cell;
  const BuiltSdf ball = build(device, ball_mesh(1, 4), cell, 0.6f);
  const Lattice& nodes = ball.sdf.nodes();
  Noise noise(2);
  for (int n = 0; n < 500; ++n) {
    const auto below = [&](uint32_t count) { return static_cast<uint32_t>(noise.next() * float(count - 1)); };
    const uint32_t i = below(nodes.nx), j = below(nodes.ny), k = below(nodes.nz);
    const Vec3 low = nodes.point(nodes.index(i, j, k)), high = nodes.point(nodes.index(i + 1, j + 1, k + 1));
    const Vec3 middle = 0.5f * (low + high), p = middle + noise.in_cube(0.3f * cell);
    const auto slope = [&](Vec3 along) {
      return sample_sdf(ball.sdf.view(), p + step * along).distance -
             sample_sdf(ball.sdf.view(), p - step * along).distance;
    };
    const Vec3 slopes{slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})};
    if (length(slopes) < step) continue;  // the middle of the ball
    EXPECT_GT(dot(sample_sdf(ball.sdf.view(), p).normal, slopes) / length(slopes), 0.99999f) << n;
  }
}

TEST(Sdf, NodesHoldTheDistanceToTheTriangles) {
  pbd::CpuDevice device;
  const TriangleMesh mesh = box_mesh({-0.5f, -0.25f, -0.5f}, {0.5f, 0.25f, 0.5f});
  const BuiltSdf box = build(device, mesh, 0.1f, 0.2f);
  const Lattice& nodes = box.sdf.nodes();
  const std::vector<float> values = box.sdf.values().read(nodes.count());
  for (uint32_t at = 0; at < nodes.count(); ++at) {
    const Vec3 q = abs(nodes.point(at)) - Vec3{0.5f, 0.25f, 0.5f};
    const float exact = length(max(q, Vec3{0, 0, 0})) + std::min(max_component(q), 0.0f);
    ASSERT_NEAR(values[at], exact, 1e-5f);
  }
}

TEST(Sdf, TheGridReachesBeyondTheMargin) {
  pbd::CpuDevice device;
  const BuiltSdf box = build(device, box_mesh({1, 2, 3}, {2, 4, 6}), 0.25f, 0.4f);
  const Lattice& n = box.sdf.nodes();
  const Vec3 upper = n.point(n.nx - 1, n.ny - 1, n.nz - 1);
  EXPECT_LE(max_component(n.origin - (Vec3{1, 2, 3} - Vec3{0.5f, 0.5f, 0.5f})), 0);
  EXPECT_LE(max_component(Vec3{2.5f, 4.5f, 6.5f} - upper), 0);
  EXPECT_LT(max_component(upper - Vec3{2.5f, 4.5f, 6.5f}), 0.3f);
}

TEST(Sdf, BeyondTheGridItIsContinuousPositiveAndNeverSaysTooMuch) {
  pbd::CpuDevice device;
  const BuiltSdf ball = build(device, ball_mesh(1, 4), 0.1f, 0.1f);
  const SdfView view = ball.sdf.view();
  Noise noise(2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = noise.in_cube(6);
    const Vec3 border = clamp_to_grid(view, p);
    if (border == p) continue;
    const SurfaceSample sample = sample_sdf(view, p);
    EXPECT_GT(sample.distance, 0);
    EXPECT_LE(sample.distance, length(p) - 1 + 0.01f);
    EXPECT_GE(sample.distance, length(p - border));
    const SurfaceSample inner = sample_sdf(view, border),
                        outer = sample_sdf(view, border + 1e-5f * (p - border));
    EXPECT_NEAR(inner.distance, outer.distance, 1e-3f);
    EXPECT_GT(dot(inner.normal, outer.normal), 0.99f);
  }
}

TEST(Sdf, APointThatIsNotANumberReadsNoForeignMemory) {
  pbd::CpuDevice device;
  const BuiltSdf box = build(device, box_mesh({0, 0, 0}, {1, 1, 1}), 0.2f, 0.1f);
  const float nan = std::nanf(""), huge = 3e38f;
  EXPECT_TRUE(std::isnan(sample_sdf(box.sdf.view(), {nan, nan, nan}).distance));
  EXPECT_GT(sample_sdf(box.sdf.view(), {huge, -huge, huge}).distance, 0);
}

TEST(Sdf, OverlappingPartsAreOneSolid) {
  pbd::CpuDevice device;
  const TriangleMesh mesh = joined(box_mesh({-0.6f, -0.2f, -0.2f}, {0.2f, 0.2f, 0.2f}),
                                   box_mesh({-0.2f, -0.3f, -0.3f}, {0.6f, 0.3f, 0.3f}));
  const BuiltSdf both = build(device, mesh, 0.05f, 0.1f);
  EXPECT_LT(sample_sdf(both.sdf.view(), {0, 0, 0}).distance, 0);
  EXPECT_LT(sample_sdf(both.sdf.view(), {-0.5f, 0, 0}).distance, 0);
  EXPECT_LT(sample_sdf(both.sdf.view(), {0.5f, 0.25f, 0}).distance, 0);
  EXPECT_GT(sample_sdf(both.sdf.view(), {-0.5f, 0.25f, 0}).distance, 0);
}

// A ball that lacks its cap above y = 0.7. What closes it lies between the rim's plane and where the cap was.
TEST(Sdf, AHoleIsClosedWithoutAJump) {
  pbd::CpuDevice device;
  const float cell_size = 0.05f;
  const BuiltSdf open = build(device, open_ball_mesh(1, 4, 0.7f), cell_size, 0.2f);
  EXPECT_LE(largest_step(open.sdf), 1.001f * cell_size);
  const SdfView view = open.sdf.view();
  EXPECT_LT(sample_sdf(view, {0, 0.3f, 0}).distance, -0.2f);
  EXPECT_GT(sample_sdf(view, {0, 0.9f, 0}).distance, 0);
  EXPECT_LT(sample_sdf(view, {0, 1.05f, 0}).distance, 0.5f);
  float crossing = 0.3f;
  while (sample_sdf(view, {0, crossing, 0}).distance < 0) crossing += 0.01f;
  EXPECT_GT(crossing, 0.45f);
  EXPECT_LT(crossing, 0.85f);
  EXPECT_GT(sample_sdf(view, {0, crossing, 0}).normal.y, 0.9f);
}

TEST(Sdf, SignsOfAnOpenMeshAreTheWindingNumbers) {
  pbd::CpuDevice device;
  const BuiltSdf open = build(device, open_ball_mesh(1, 4, 0.7f), 0.08f, 0.2f);
  Noise noise(9);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = noise.in_cube(1.1f);
    const float distance = sample_sdf(open.sdf.view(), p).distance;
    if (std::fabs(distance) < 0.04f) continue;  // half a cell
    EXPECT_EQ(distance < 0, is_inside(open.bvh.view(), p));
  }
}

TEST(Sdf, ThreadsDoNotChangeABit) {
  pbd::CpuDevice one(1), two(2);
  const TriangleMesh mesh = open_ball_mesh(1, 3, 0.6f);
  const BuiltSdf a = build(one, mesh, 0.1f, 0.1f), b = build(two, mesh, 0.1f, 0.1f);
  EXPECT_EQ(a.sdf.values().read(a.sdf.nodes().count()), b.sdf.values().read(b.sdf.nodes().count()));
}

TEST(Sdf, BadSizesAreRefusedByName) {
  pbd::CpuDevice device;
  const TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  for (float cell_size : {0.0f, -1.0f, std::nanf(""), 1e-3f}) {
    try {
      build(device, mesh, cell_size, 0.1f);
      ADD_FAILURE() << cell_size << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
      EXPECT_NE(std::string(error.what()).find("cell_size"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(build(device, mesh, 0.1f, -0.1f), Error);
}

Sdf build_to_error(pbd::CpuDevice& device, const TriangleMesh& mesh, float target_error, float margin,
                   uint32_t max_points = max_sdf_points) {
  const DeviceTriangleBvh tree(device, TriangleBvh(mesh));
  return build_sdf_to_error(device, mesh, tree, target_error, margin, max_points);
}

TEST(SdfToError, CellsAreAsSmallAsTheTargetAsks) {
  pbd::CpuDevice device;
  const TriangleMesh ball = ball_mesh(1, 4);
  const TriangleBvh tree(ball);
  float last = 1;
  for (float target : {0.02f, 0.005f, 0.003f}) {
    const Sdf sdf = build_to_error(device, ball, target, 0.2f);
    EXPECT_LT(sdf.nodes().spacing, last);
    EXPECT_GT(sdf.nodes().spacing, 3 * target);  // a smooth surface needs no fine cells
    last = sdf.nodes().spacing;
    Noise noise(7);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 p = (0.95f + 0.1f * noise.next()) * normalized_or(noise.in_cube(1), {0, 1, 0});
      const float distance = closest_point(tree.view(), p).distance;
      const float exact = is_inside(tree.view(), p) ? -distance : distance;
      EXPECT_NEAR(sample_sdf(sdf.view(), p).distance, exact, 1.1f * target);  // other points than were tried
    }
  }
}

// Inside a wall the distance is that of a cup, by hand.
TEST(SdfToError, ThinWallsAreResolved) {
  pbd::CpuDevice device;
  const float half = 0.1f, wall = 0.01f, target = 0.002f;
  const Sdf sdf = build_to_error(device, cup_mesh(half, wall), target, 0.02f);
  EXPECT_LE(sdf.nodes().spacing, 0.5f * wall);
  EXPECT_GT(sdf.nodes().spacing, 0.1f * wall);
  for (float across = -0.008f; across < 0.02f; across += 0.0007f) {
    for (float y : {0.05f, 0.083f, 0.121f, 0.15f}) {
      const float exact = std::max(across - 0.01f, -across);  // of the wall from 0 to .01, inwards
      const float side = half - across, along = 0.013f;
      for (Vec3 p : {Vec3{side, y, along}, Vec3{-side, y, along}, Vec3{along, y, -side}}) {
        EXPECT_NEAR(sample_sdf(sdf.view(), p).distance, exact, target);
      }
    }
  }
}

TEST(SdfToError, AHoleIsNoError) {
  pbd::CpuDevice device;
  const Sdf sdf = build_to_error(device, open_ball_mesh(1, 4, 0.7f), 0.03f, 0.2f);
  EXPECT_LE(sdf.nodes().spacing, 0.13f);
  EXPECT_LT(sample_sdf(sdf.view(), {0, 0.3f, 0}).distance, -0.2f);
}

TEST(SdfToError, TheErrorIsMeasured) {
  pbd::CpuDevice device;
  const TriangleMesh mesh = box_mesh({-0.53f, -0.51f, -0.57f}, {0.5f, 0.52f, 0.55f});
  const DeviceTriangleBvh tree(device, TriangleBvh(mesh));
  Sdf sdf = build_sdf(device, tree, 0.1f, 0.2f);
  const float before = sdf_error(device, mesh, tree, sdf);
  EXPECT_GT(before, 0.01f);  // at the edges
  EXPECT_LT(before, 0.05f);
  std::vector<float> values = sdf.values().read(sdf.nodes().count());
  for (float& d : values) d += 0.1f;
  sdf.values().write(values);
  EXPECT_NEAR(sdf_error(device, mesh, tree, sdf), 0.1f + before, 0.02f);
}

TEST(SdfToError, TargetsOutOfReachAreRefusedWithTheNumbers) {
  pbd::CpuDevice device;
  const TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  const auto refused = [&](float target, float margin, ErrorCode code) -> std::string {
    try {
      build_to_error(device, mesh, target, margin, 100000);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), code) << error.what();
      return error.what();
    }
    return "nothing";
  };
  const std::string why = refused(0.001f, 0.1f, ErrorCode::capacity);
  EXPECT_NE(why.find("max_error is 0.001 m"), std::string::npos) << why;
  EXPECT_NE(why.find("100000"), std::string::npos) << why;
  EXPECT_NE(refused(0.001f, 100, ErrorCode::capacity), "nothing");  // where no field at all fits
  for (float bad : {0.0f, -1.0f, std::nanf("")}) refused(bad, 0.1f, ErrorCode::invalid_argument);
  EXPECT_NE(refused(0.01f, std::nanf(""), ErrorCode::invalid_argument), "nothing");
}

}  // namespace
}  // namespace meniscus::collision
