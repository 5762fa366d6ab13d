// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Distance fields of scanned meshes against sums over all of their triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "collision/mesh/triangle_bvh_query.h"
#include "collision/sdf/build.h"
#include "pbd/device/cpu/cpu_device.h"
#include "tests/unit/collision/mesh_shapes.h"

namespace meniscus::collision {
namespace {

struct Double3 {
  double x, y, z;
};

double dot(const Double3& a, const Double3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
double triple(const Double3& a, const Double3& b, const Double3& c) {
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
}

// atan2(y, x); most triangles fill so small an angle that the series has all digits.
double angle(double y, double x) {
  if (!(x > 0 && std::fabs(y) < 0.01 * x)) return std::atan2(y, x);
  const double t = y / x, tt = t * t;
  return t * (1 + tt * (-1.0 / 3 + tt * (1.0 / 5 + tt * (-1.0 / 7 + tt / 9))));
}

// The winding number, in double over all triangles (Van Oosterom and Strackee 1983).
double exact_winding(const TriangleMesh& mesh, Vec3 p) {
  std::vector<Double3> towards;
  towards.reserve(mesh.vertices.size());
  for (Vec3 v : mesh.vertices) {
    const Double3 d{double{v.x} - p.x, double{v.y} - p.y, double{v.z} - p.z};
    const double scale = 1 / std::sqrt(dot(d, d));
    towards.push_back({d.x * scale, d.y * scale, d.z * scale});
  }
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Double3 &a = towards[t[0]], &b = towards[t[1]], &c = towards[t[2]];
    sum += angle(triple(a, b, c), 1 + dot(a, b) + dot(b, c) + dot(c, a));
  }
  return sum / (2 * std::numbers::pi);
}

float exact_distance(const TriangleMesh& mesh, Vec3 p) {
  float nearest = 3e38f;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Triangle t{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    nearest = std::min(nearest, length(offset_to_triangle(t, p)));
  }
  return nearest;
}

struct Scan {
  const char* name;
  std::string path;
};

class ScannedSdf : public testing::TestWithParam<Scan> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(GetParam().path)) GTEST_SKIP() << "the mesh is not here";
    mesh_ = load_mesh(GetParam().path);
    const Aabb box = bounds(mesh_);
    cell_ = max_component(box.upper - box.lower) / 100;
    tree_.emplace(mesh_);
    const DeviceTriangleBvh copy(device_, *tree_);
    sdf_.emplace(build_sdf(device_, copy, cell_, 4 * cell_));
  }

  // In the field's box.
  std::vector<Vec3> random_points(uint32_t count, uint32_t seed) const {
    const Lattice& n = sdf_->nodes();
    const Vec3 extent = n.point(n.nx - 1, n.ny - 1, n.nz - 1) - n.origin;
    Noise noise(seed);
    std::vector<Vec3> points;
    while (points.size() < count) {
      const float x = noise.next(), y = noise.next(), z = noise.next();
      points.push_back(n.origin + Vec3{x * extent.x, y * extent.y, z * extent.z});
    }
    return points;
  }

  std::vector<Vec3> points_beside(uint32_t count) const {
    Noise noise(5);
    std::vector<Vec3> points;
    while (points.size() < count) {
      const auto v = static_cast<size_t>(noise.next() * static_cast<float>(mesh_.vertices.size()));
      points.push_back(mesh_.vertices[v] + noise.in_cube(2 * cell_));
    }
    return points;
  }

  float largest_error(const std::vector<Vec3>& points) {
    std::vector<float> errors(points.size());
    device_.parallel_for("exact distances", static_cast<uint32_t>(points.size()), [&](uint32_t i) {
      const float sampled = sample_sdf(sdf_->view(), points[i]).distance;
      errors[i] = std::fabs(std::fabs(sampled) - exact_distance(mesh_, points[i]));
    });
    return *std::max_element(errors.begin(), errors.end());
  }

  pbd::CpuDevice device_;
  TriangleMesh mesh_;
  float cell_ = 0;
  std::optional<TriangleBvh> tree_;
  std::optional<Sdf> sdf_;
};

TEST_P(ScannedSdf, IsOffByHalfACellAtMost) {
  const float anywhere = largest_error(random_points(4000, 1)), beside = largest_error(points_beside(4000));
  std::printf("%s: off by %.3f cells anywhere, %.3f near the surface\n", GetParam().name,
              static_cast<double>(anywhere / cell_), static_cast<double>(beside / cell_));
  EXPECT_LE(anywhere, 0.5f * cell_);
  EXPECT_LE(beside, 0.5f * cell_);
}

TEST_P(ScannedSdf, HasTheRightSignFurtherThanACellFromTheSurface) {
  std::vector<Vec3> points = random_points(14000, 2);
  std::erase_if(points, [&](Vec3 p) { return closest_point(tree_->view(), p).distance <= cell_; });
  ASSERT_GE(points.size(), 10000u);
  points.resize(10000);
  std::vector<uint8_t> wrong(points.size());
  device_.parallel_for("exact signs", static_cast<uint32_t>(points.size()), [&](uint32_t i) {
    const bool inside = sample_sdf(sdf_->view(), points[i]).distance < 0;
    wrong[i] = inside != (std::fabs(exact_winding(mesh_, points[i])) > 0.5);
  });
  EXPECT_EQ(std::count(wrong.begin(), wrong.end(), 1), 0);
}

std::vector<Scan> scans() {
  const char* armadillo = std::getenv("MENISCUS_ARMADILLO");
  return {{"bunny", "/usr/share/glmark2/models/bunny.obj"}, {"armadillo", armadillo ? armadillo : ""}};
}

INSTANTIATE_TEST_SUITE_P(Meshes, ScannedSdf, testing::ValuesIn(scans()),
                         [](const auto& scan) { return std::string(scan.param.name); });

}  // namespace
}  // namespace meniscus::collision
