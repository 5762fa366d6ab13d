// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Chooses the points at which the error of a distance field is measured, and reports errors.
#include "collision/sdf/sdf_error_points.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "collision/mesh/triangle.h"
#include "pbd/math/vec.h"
#include "pbd/mesh_edges.h"

namespace meniscus::collision {

using pbd::edge_uses;
using pbd::EdgeUse;
using pbd::for_each_edge;

namespace {

// Numbers in [0, 1) that are the same on every platform (splitmix64, Steele et al. 2014).
class Random {
 public:
  double next() {
    uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53;
  }
  float between(float lower, float upper) { return lower + static_cast<float>(next()) * (upper - lower); }

 private:
  uint64_t state_ = 0;
};

Triangle corners_of(const TriangleMesh& mesh, size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

// Cumulative sums of the triangles' areas.
std::vector<double> summed_areas(const TriangleMesh& mesh) {
  std::vector<double> sums;
  double sum = 0;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    sum += 0.5 * length(area_normal(corners_of(mesh, t)));
    sums.push_back(sum);
  }
  return sums;
}

Vec3 point_on(const Triangle& t, Random& random) {
  const auto across = static_cast<float>(std::sqrt(random.next())), along = static_cast<float>(random.next());
  return t.a + across * (1 - along) * (t.b - t.a) + across * along * (t.c - t.a);
}

}  // namespace

std::vector<Vec3> points_on_surface(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.vertices.size());
  for (const auto& t : mesh.triangles) {
    for (uint32_t v : t) used[v] = true;
  }
  std::vector<Vec3> points;
  for (size_t v = 0; v < used.size(); ++v) {
    if (used[v]) points.push_back(mesh.vertices[v]);
  }
  for_each_edge(edge_uses(mesh), [&](std::span<const EdgeUse> edge) {
    points.push_back(0.5f * (mesh.vertices[edge[0].low] + mesh.vertices[edge[0].high]));
  });
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle corners = corners_of(mesh, t);
    points.push_back((corners.a + corners.b + corners.c) / 3);
  }
  return points;
}

std::vector<Vec3> points_near_surface(const TriangleMesh& mesh, uint32_t count, float reach) {
  const std::vector<double> areas = summed_areas(mesh);
  Random random;
  std::vector<Vec3> points;
  for (uint32_t i = 0; i < count; ++i) {
    const auto chosen = std::upper_bound(areas.begin(), areas.end() - 1, random.next() * areas.back());
    const Vec3 on = point_on(corners_of(mesh, static_cast<size_t>(chosen - areas.begin())), random);
    const float x = random.between(-reach, reach), y = random.between(-reach, reach),
                z = random.between(-reach, reach);
    points.push_back(on + Vec3{x, y, z});
  }
  return points;
}

double lattice_points_around(const Aabb& box, float spacing, float margin) {
  const auto along = [&](float lower, float upper) {
    return std::ceil((static_cast<double>(upper) - lower + 2.0 * margin) / spacing) + 2;
  };
  return along(box.lower.x, box.upper.x) * along(box.lower.y, box.upper.y) * along(box.lower.z, box.upper.z);
}

void check_error_target(float target_error, float margin) {
  const bool sound = target_error > 0 && std::isfinite(target_error) && margin >= 0 && std::isfinite(margin);
  if (sound) return;
  throw Error(ErrorCode::invalid_argument,
              "max_error is " + std::to_string(target_error) + " m and margin " + std::to_string(margin) +
                  " m: they must be finite, the one positive, the other not negative");
}

void refuse_error_target(float target_error, float error, float cell_size, double points,
                         uint32_t max_points) {
  std::ostringstream message;
  message << "max_error is " << target_error << " m, which takes cells of " << cell_size
          << " m or less: their " << points << " points are more than the " << max_points << " allowed";
  if (std::isfinite(error)) message << " (cells of twice that size are off by " << error << " m)";
  throw Error(ErrorCode::capacity, message.str() + ". Allow for a larger error");
}

}  // namespace meniscus::collision
