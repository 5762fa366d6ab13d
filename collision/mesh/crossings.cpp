// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the pairs of triangles of a mesh that pass through one another.
#include "collision/mesh/crossings.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>

#include "collision/mesh/triangle_bvh.h"
#include "collision/mesh/tuning.h"

namespace meniscus::collision {

namespace {

using Vector = Eigen::Vector3d;
using Corners = std::array<uint32_t, 3>;

Vector exact(Vec3 v) {
  return {v.x, v.y, v.z};
}

bool share_a_vertex(const Corners& a, const Corners& b) {
  return std::any_of(a.begin(), a.end(), [&](uint32_t v) { return v == b[0] || v == b[1] || v == b[2]; });
}

bool overlap(const Aabb& a, const BvhNode& b) {
  return a.lower.x <= b.upper.x && a.lower.y <= b.upper.y && a.lower.z <= b.upper.z &&  //
         b.lower.x <= a.upper.x && b.lower.y <= a.upper.y && b.lower.z <= a.upper.z;
}

// How a segment meets a triangle whose plane it crosses.
constexpr int misses = -2, pierces = -1;  // otherwise the number of the side that it passes through

// Where x lies in the triangle's plane. Corners, where many triangles meet, are left to the neighbouring
// triangles.
int place_in(const std::array<Vector, 3>& corners, const Vector& normal, const Vector& x, double touch) {
  int on_side = pierces;
  for (int k = 0; k < 3; ++k) {
    const Vector& a = corners[k];
    const Vector along = (corners[(k + 1) % 3] - a).normalized();
    const double inside = normal.cross(along).dot(x - a);
    if (inside < -touch) return misses;
    if (inside > touch) continue;
    if (on_side != pierces) return misses;
    on_side = k;
  }
  return on_side;
}

class Search {
 public:
  explicit Search(const TriangleMesh& mesh) : mesh_(mesh), tree_(mesh) {
    const Aabb box = tree_.bounds();
    touch_ = mesh_tuning::touch_distance * (exact(box.upper) - exact(box.lower)).norm();
  }

  std::vector<std::pair<uint32_t, uint32_t>> run() {
    for (uint32_t slot = 0; slot < tree_.triangles().size(); ++slot) look_from(slot);
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
  }

 private:
  // A side of another triangle, named by its vertices, through which a side of this one passes.
  struct Passed {
    int side;
    std::pair<uint32_t, uint32_t> edge;
  };

  void look_from(uint32_t slot) {
    passed_.clear();
    const Triangle& t = tree_.triangles()[slot];
    const Aabb box{min(t.a, min(t.b, t.c)), max(t.a, max(t.b, t.c))};
    const uint32_t face = tree_.sources()[slot];
    for (uint32_t at = 0; at < tree_.nodes().size();) {
      const BvhNode& node = tree_.nodes()[at];
      if (!overlap(box, node)) {
        at = node.end;
        continue;
      }
      for (uint32_t i = node.first; i < node.first + node.count; ++i) test_sides(t, face, i);
      ++at;
    }
  }

  void test_sides(const Triangle& of, uint32_t face, uint32_t other_slot) {
    const uint32_t other = tree_.sources()[other_slot];
    if (share_a_vertex(mesh_.triangles[face], mesh_.triangles[other])) return;
    const Triangle& t = tree_.triangles()[other_slot];
    const std::array<Vector, 3> corners{exact(t.a), exact(t.b), exact(t.c)};
    const Vector normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    const std::array<Vector, 3> ends{exact(of.a), exact(of.b), exact(of.c)};
    std::array<double, 3> height;
    for (int k = 0; k < 3; ++k) height[k] = normal.dot(ends[k] - corners[0]);
    for (int k = 0; k < 3; ++k) {
      const double from = height[k], to = height[(k + 1) % 3];
      if (!(std::min(from, to) < -touch_ && std::max(from, to) > touch_)) continue;
      const Vector x = ends[k] + from / (from - to) * (ends[(k + 1) % 3] - ends[k]);
      note(face, other, k, place_in(corners, normal, x, touch_));
    }
  }

  // The edge between two faces is passed through where the planes of both faces are crossed at it. A single
  // plane may belong to a face that merely touches there.
  void note(uint32_t face, uint32_t other, int side, int place) {
    if (place == misses) return;
    if (place != pierces) {
      const Corners& c = mesh_.triangles[other];
      const Passed passed{side, std::minmax(c[place], c[(place + 1) % 3])};
      const bool both = std::any_of(passed_.begin(), passed_.end(), [&](const Passed& p) {
        return p.side == passed.side && p.edge == passed.edge;
      });
      passed_.push_back(passed);
      if (!both) return;
    }
    found_.push_back(std::minmax(face, other));
  }

  const TriangleMesh& mesh_;
  TriangleBvh tree_;
  double touch_;
  std::vector<Passed> passed_;
  std::vector<std::pair<uint32_t, uint32_t>> found_;
};

}  // namespace

std::vector<std::pair<uint32_t, uint32_t>> crossing_triangles(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return {};
  return Search(mesh).run();
}

}  // namespace meniscus::collision
