// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of triangles and of their bounding volume hierarchy against brute force.
#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <cstring>
#include <set>

#include "collision/mesh/triangle_bvh_query.h"
#include "pbd/device/cpu/cpu_device.h"
#include "tests/unit/collision/mesh_shapes.h"

namespace meniscus::collision {
namespace {

Triangle triangle_of(const TriangleMesh& mesh, uint32_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

float brute_distance(const TriangleMesh& mesh, Vec3 p) {
  float nearest = 3e38f;
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    nearest = std::min(nearest, length(offset_to_triangle(triangle_of(mesh, t), p)));
  }
  return nearest;
}

double brute_winding(const TriangleMesh& mesh, Vec3 p) {
  double sum = 0;
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) sum += covered_fraction(triangle_of(mesh, t), p);
  return sum;
}

// The nearest of a dense set of points of the triangle, by which the closed form is held to account.
float sampled_distance(const Triangle& t, Vec3 p) {
  constexpr int n = 60;
  float nearest = 3e38f;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      const float u = static_cast<float>(i) / n, v = static_cast<float>(j) / n;
      nearest = std::min(nearest, length(t.a + u * (t.b - t.a) + v * (t.c - t.a) - p));
    }
  }
  return nearest;
}

TEST(Triangle, NearestPointAgreesWithSampling) {
  Noise noise(1);
  for (int trial = 0; trial < 300; ++trial) {
    const Triangle t{noise.in_cube(1), noise.in_cube(1), noise.in_cube(1)};
    const Vec3 p = noise.in_cube(2);
    const float exact = length(offset_to_triangle(t, p)), sampled = sampled_distance(t, p);
    EXPECT_LE(exact, sampled + 1e-6f);
    EXPECT_GE(exact, sampled - 0.05f);
  }
}

TEST(Triangle, NearestPointIsRightForSmallAndFlatTrianglesFarAway) {
  const Triangle small{{0, 0, 0}, {1e-3f, 0, 0}, {0, 1e-3f, 0}};
  EXPECT_LT(length(offset_to_triangle(small, {3e-4f, 3e-4f, 10}) - Vec3{0, 0, -10}), 1e-4f);
  EXPECT_LT(length(offset_to_triangle(small, {10, 0, 0}) - Vec3{1e-3f - 10, 0, 0}), 1e-5f);
  const Triangle line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  EXPECT_LT(length(offset_to_triangle(line, {1.5f, 1, 0}) - Vec3{0, -1, 0}), 1e-6f);
  const Triangle point{{1, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  EXPECT_LT(length(offset_to_triangle(point, {0, 0, 0}) - Vec3{1, 0, 0}), 1e-6f);
}

TEST(Triangle, AFaceOfAnOctahedronCoversAnEighth) {
  const Triangle face{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_NEAR(covered_fraction(face, {0, 0, 0}), 0.125f, 1e-6f);
  EXPECT_NEAR(covered_fraction({face.a, face.c, face.b}, {0, 0, 0}), -0.125f, 1e-6f);
}

struct MeshCase {
  const char* name;
  TriangleMesh mesh;
};

class TriangleBvhOver : public testing::TestWithParam<MeshCase> {};

TEST_P(TriangleBvhOver, ClosestPointAgreesWithBruteForce) {
  const TriangleMesh& mesh = GetParam().mesh;
  const TriangleBvh bvh(mesh);
  Noise noise(7);
  uint32_t guess = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = noise.in_cube(1.5f);
    const ClosestPoint closest = closest_point(bvh.view(), p, guess);
    EXPECT_NEAR(closest.distance, brute_distance(mesh, p), 1e-6f);
    EXPECT_NEAR(length(closest.point - p), closest.distance, 1e-6f);
    EXPECT_NEAR(length(offset_to_triangle(triangle_of(mesh, closest.triangle), p)), closest.distance, 1e-6f);
    EXPECT_EQ(closest.distance, closest_point(bvh.view(), p).distance);
    EXPECT_EQ(distance_within(bvh.view(), p, 0.3f), std::min(closest.distance, 0.3f));
    guess = closest.slot;
  }
}

TEST_P(TriangleBvhOver, WindingNumberAgreesWithBruteForce) {
  const TriangleMesh& mesh = GetParam().mesh;
  const TriangleBvh bvh(mesh);
  Noise noise(11);
  double error = 0;
  constexpr int points = 300;
  for (int i = 0; i < points; ++i) {
    const Vec3 p = noise.in_cube(1.5f);
    const double off = std::abs(winding_number(bvh.view(), p) - brute_winding(mesh, p));
    EXPECT_LT(off, 0.06);
    error += off / points;
  }
  EXPECT_LT(error, 0.01);
}

TEST_P(TriangleBvhOver, EveryTriangleIsInOneLeafAndEveryNodeHoldsItsOwn) {
  const TriangleMesh& mesh = GetParam().mesh;
  const TriangleBvh bvh(mesh);
  std::set<uint32_t> seen;
  for (uint32_t at = 0; at < bvh.nodes().size(); ++at) {
    const BvhNode& node = bvh.nodes()[at];
    for (uint32_t inner = at; inner < node.end; ++inner) {
      EXPECT_EQ(length(min(bvh.nodes()[inner].lower, node.lower) - node.lower), 0);
      EXPECT_EQ(length(max(bvh.nodes()[inner].upper, node.upper) - node.upper), 0);
    }
    for (uint32_t i = node.first; i < node.first + node.count; ++i) {
      EXPECT_TRUE(seen.insert(bvh.sources()[i]).second);
      EXPECT_EQ(std::memcmp(&bvh.triangles()[i].a, &mesh.vertices[mesh.triangles[bvh.sources()[i]][0]],
                            sizeof(Vec3)),
                0);
    }
  }
  EXPECT_EQ(seen.size(), mesh.triangles.size());
}

INSTANTIATE_TEST_SUITE_P(Meshes, TriangleBvhOver,
                         testing::Values(MeshCase{"ball", ball_mesh(1, 4)},
                                         MeshCase{"open_ball", open_ball_mesh(1, 4, 0.5f)},
                                         MeshCase{"box", box_mesh({-1, -0.5f, -0.25f}, {1, 0.5f, 0.25f})}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(TriangleBvh, OneTriangleWillDo) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const TriangleBvh bvh(mesh);
  const ClosestPoint closest = closest_point(bvh.view(), {0.25f, 0.25f, -2});
  EXPECT_FLOAT_EQ(closest.distance, 2);
  EXPECT_EQ(closest.triangle, 0u);
}

TEST(TriangleBvh, AMeshWithoutTrianglesIsRefused) {
  EXPECT_THROW(TriangleBvh(TriangleMesh{{{0, 0, 0}}, {}}), Error);
}

TEST(TriangleBvh, AMeshThatIsInsideOutHasTheSameInside) {
  TriangleMesh mesh = ball_mesh(1, 3);
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  const TriangleBvh bvh(mesh);
  EXPECT_TRUE(is_inside(bvh.view(), {0.3f, 0.2f, 0.1f}));
  EXPECT_FALSE(is_inside(bvh.view(), {1.3f, 0.2f, 0.1f}));
}

TEST(TriangleBvh, TheDeviceCopyAnswersAlike) {
  pbd::CpuDevice device;
  const TriangleBvh bvh(ball_mesh(1, 3));
  const DeviceTriangleBvh copy(device, bvh);
  EXPECT_EQ(copy.bounds().upper, (Vec3{1, 1, 1}));
  Noise noise(5);
  for (int i = 0; i < 50; ++i) {
    const Vec3 p = noise.in_cube(2);
    EXPECT_EQ(closest_point(copy.view(), p).distance, closest_point(bvh.view(), p).distance);
    EXPECT_EQ(winding_number(copy.view(), p), winding_number(bvh.view(), p));
  }
}

}  // namespace
}  // namespace meniscus::collision
