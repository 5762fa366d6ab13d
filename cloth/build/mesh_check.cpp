// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks whether a mesh can serve as cloth.
#include <meniscus/error.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "cloth/build/cloth_mesh.h"
#include "cloth/build/rest_geometry.h"
#include "cloth/build/topology.h"
#include "cloth/build/tuning.h"
#include "pbd/math/vec.h"

namespace meniscus::cloth {

namespace {

// The ratio of a triangle's height to its longest edge below which its corners lie on a line, to rounding.
constexpr double no_area = 1e-6;

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  throw Error(ErrorCode::mesh, text.str());
}

void check_sizes(const ClothMesh& mesh) {
  if (mesh.triangles.empty()) refuse("a cloth mesh has no triangles");
  if (!mesh.material.empty() && mesh.material.size() != mesh.vertices.size()) {
    refuse("a cloth mesh has ", mesh.vertices.size(), " vertices and ", mesh.material.size(),
           " material coordinates; it must have as many, or none");
  }
}

void check_vertices(const ClothMesh& mesh) {
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!is_finite(mesh.vertices[v])) refuse("vertex ", v, " of a cloth mesh is not finite");
  }
  for (size_t v = 0; v < mesh.material.size(); ++v) {
    if (!std::isfinite(mesh.material[v][0]) || !std::isfinite(mesh.material[v][1])) {
      refuse("the material coordinates of vertex ", v, " of a cloth mesh are not finite");
    }
  }
}

void check_indices(const ClothMesh& mesh) {
  std::vector<bool> used(mesh.vertices.size());
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (uint32_t v : mesh.triangles[t]) {
      if (v >= used.size()) {
        refuse("triangle ", t, " of a cloth mesh has the vertex ", v, ", but there are ", used.size());
      }
      used[v] = true;
    }
  }
  const auto idle = std::find(used.begin(), used.end(), false);
  if (idle != used.end()) refuse("vertex ", idle - used.begin(), " of a cloth mesh is in no triangle");
}

// The height of a triangle over its longest edge, and its shortest edge, which starts at a corner.
struct Proportions {
  double height, longest, shortest;
  size_t corner;
};

Proportions proportions(const ClothMesh& mesh, const std::array<uint32_t, 3>& t) {
  Eigen::Vector3d x[3];
  for (size_t k = 0; k < 3; ++k) x[k] = to_double(mesh.vertices[t[k]]);
  double lengths[3];
  for (size_t k = 0; k < 3; ++k) lengths[k] = (x[(k + 1) % 3] - x[k]).norm();
  const auto [shortest, longest] = std::minmax_element(lengths, lengths + 3);
  const double twice_area = (x[1] - x[0]).cross(x[2] - x[0]).norm();
  return {*longest > 0 ? twice_area / *longest : 0, *longest, *shortest,
          static_cast<size_t>(shortest - lengths)};
}

void check_area(const ClothMesh& mesh, uint32_t t) {
  const std::array<uint32_t, 3>& corners = mesh.triangles[t];
  const Proportions p = proportions(mesh, corners);
  if (p.height <= no_area * p.longest) refuse("triangle ", t, " of a cloth mesh has no area");
  if (p.height >= build_tuning::least_height * p.longest) return;
  refuse("triangle ", t, " of a cloth mesh is ", p.height, " m high over an edge of ", p.longest,
         " m; its height must be at least ", build_tuning::least_height,
         " of that. Its shortest edge, between the vertices ", corners[p.corner], " and ",
         corners[(p.corner + 1) % 3], ", is ", p.shortest, " m long");
}

void check_triangles(const ClothMesh& mesh) {
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    check_area(mesh, t);
    if (triangle_at_rest(mesh, t).warp.isZero()) {
      refuse("the material coordinates of triangle ", t, " of a cloth mesh lie on a line");
    }
  }
}

void check_edges(const ClothMesh& mesh) {
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for_each_edge(uses, [](std::span<const EdgeUse> edge) {
    if (edge.size() > 2) {
      refuse("the edge between the vertices ", edge[0].low, " and ", edge[0].high, " of a cloth mesh has ",
             edge.size(), " triangles; it may have 2 at most");
    }
    if (edge.size() == 2 && edge[0].opposite == edge[1].opposite) {
      refuse("the triangles ", edge[0].triangle, " and ", edge[1].triangle,
             " of a cloth mesh have the same vertices");
    }
  });
}

}  // namespace

void check_mesh(const ClothMesh& mesh) {
  check_sizes(mesh);
  check_vertices(mesh);
  check_indices(mesh);
  check_triangles(mesh);
  check_edges(mesh);
}

}  // namespace meniscus::cloth
