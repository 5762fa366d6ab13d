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
#include "pbd/math/vec.h"

namespace meniscus::cloth {

namespace {

// The least ratio of a triangle's height to its longest edge. Below it, a normal in floats is meaningless.
constexpr double least_height = 1e-6;

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

bool has_area(const ClothMesh& mesh, const std::array<uint32_t, 3>& t) {
  const Eigen::Vector3d a = to_double(mesh.vertices[t[0]]);
  const Eigen::Vector3d ab = to_double(mesh.vertices[t[1]]) - a, ac = to_double(mesh.vertices[t[2]]) - a;
  const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
  return ab.cross(ac).norm() > least_height * longest;
}

void check_triangles(const ClothMesh& mesh) {
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!has_area(mesh, mesh.triangles[t])) refuse("triangle ", t, " of a cloth mesh has no area");
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
