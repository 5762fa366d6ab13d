// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of how meshes are filled with particles.
#include "collision/sdf/mesh_sampling.h"

#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <cmath>
#include <filesystem>

#include "pbd/device/cpu/cpu_device.h"
#include "tests/unit/collision/mesh_shapes.h"

namespace meniscus::collision {
namespace {

std::vector<Vec3> fill(const TriangleMesh& mesh, float spacing) {
  pbd::CpuDevice device;
  const DeviceTriangleBvh bvh(device, TriangleBvh(mesh));
  return lattice_points_inside(device, bvh, spacing);
}

TEST(MeshSampling, ParticlesOfABallFillItsVolume) {
  const TriangleMesh ball = ball_mesh(1, 4);
  const float s = 0.04f;
  const std::vector<Vec3> points = fill(ball, s);
  EXPECT_NEAR(static_cast<double>(points.size()) * s * s * s / signed_volume(ball), 1, 0.005);
  for (Vec3 p : points) EXPECT_LT(length(p), 1);
}

TEST(MeshSampling, ABoxOfWholeMultiplesIsFilledFromFaceToFace) {
  const std::vector<Vec3> points = fill(box_mesh({1, 0, 0}, {1.5f, 0.3f, 0.2f}), 0.1f);
  ASSERT_EQ(points.size(), 5u * 3u * 2u);
  EXPECT_LT(length(points.front() - Vec3{1.05f, 0.05f, 0.05f}), 1e-6f);
  EXPECT_LT(length(points[1] - Vec3{1.15f, 0.05f, 0.05f}), 1e-6f);
  EXPECT_LT(length(points.back() - Vec3{1.45f, 0.25f, 0.15f}), 1e-6f);
}

TEST(MeshSampling, GivenPointsAreTold) {
  pbd::CpuDevice device;
  const DeviceTriangleBvh bvh(device, TriangleBvh(ball_mesh(1, 4)));
  std::vector<Vec3> points;
  Noise noise(4);
  while (points.size() < 3000) {
    const Vec3 p = noise.in_cube(1.3f);
    if (std::fabs(length(p) - 1) > 0.01f) points.push_back(p);
  }
  const std::vector<uint8_t> inside = points_inside(device, bvh, points);
  ASSERT_EQ(inside.size(), points.size());
  for (size_t i = 0; i < points.size(); ++i) EXPECT_EQ(inside[i], length(points[i]) < 1 ? 1 : 0);
  EXPECT_TRUE(points_inside(device, bvh, {}).empty());
}

TEST(MeshSampling, AScannedMeshWithHolesIsFilled) {
  const char* const bunny_file = "/usr/share/glmark2/models/bunny.obj";
  if (!std::filesystem::exists(bunny_file))
    GTEST_SKIP() << "the bunny of the package glmark2-data is not here";
  const TriangleMesh bunny = load_mesh(bunny_file, 1);
  EXPECT_EQ(bunny.vertices.size(), 34835u);
  const double volume = signed_volume(bunny);
  const auto s = static_cast<float>(std::cbrt(volume / 20000));
  EXPECT_NEAR(static_cast<double>(fill(bunny, s).size()) * s * s * s / volume, 1, 0.01);
}

TEST(MeshSampling, BadSpacingsAreRefused) {
  const TriangleMesh box = box_mesh({0, 0, 0}, {1, 1, 1});
  for (float spacing : {0.0f, -0.1f, std::nanf(""), 1e-4f}) EXPECT_THROW(fill(box, spacing), Error);
}

}  // namespace
}  // namespace meniscus::collision
