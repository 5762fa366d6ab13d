// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes grounds for contacts from meshes.
#include "collision/rigid_contact/ground.h"

#include <cmath>
#include <unordered_map>

#include "collision/rigid_contact/tuning.h"

namespace meniscus::collision {

namespace {

uint64_t edge_key(uint32_t from, uint32_t to) {
  return uint64_t{from} << 32 | to;
}

/// Normals of a mesh: of triangles, and sums at vertices, weighted by the angles of corners.
struct Normals {
  std::vector<Vec3> triangles, vertices;

  explicit Normals(const TriangleMesh& mesh) : vertices(mesh.vertices.size(), Vec3{0, 0, 0}) {
    for (const auto& t : mesh.triangles) {
      const Vec3 p[3] = {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
      const Vec3 n = normalized_or(cross(p[1] - p[0], p[2] - p[0]), {0, 0, 0});
      triangles.push_back(n);
      for (int k = 0; k < 3; ++k) {
        const Vec3 u = normalized_or(p[(k + 1) % 3] - p[k], {0, 0, 0});
        const Vec3 v = normalized_or(p[(k + 2) % 3] - p[k], {0, 0, 0});
        vertices[t[k]] += std::acos(pbd::clamp(dot(u, v), -1, 1)) * n;
      }
    }
  }
};

/// Whether a body may rest on the edge: it is convex, and bent by more than same_normal.
bool is_sharp(Vec3 own, Vec3 beside, Vec3 along) {
  if (beside == Vec3{0, 0, 0}) return true;
  return dot(own, beside) < rigid_contact_tuning::same_normal && dot(cross(own, beside), along) > 0;
}

TriangleMesh centred(const TriangleMesh& mesh, ContactGround& ground) {
  const Aabb box = bounds(mesh);
  ground.centre = 0.5f * (box.lower + box.upper);
  ground.half = 0.5f * (box.upper - box.lower);
  TriangleMesh moved = mesh;
  for (Vec3& v : moved.vertices) v -= ground.centre;
  return moved;
}

}  // namespace

ContactGround make_contact_ground(const TriangleMesh& mesh) {
  ContactGround ground;
  const TriangleMesh moved = centred(mesh, ground);
  const TriangleBvh tree(moved);
  const Normals normals(moved);
  std::unordered_map<uint64_t, uint32_t> owner;
  for (uint32_t t = 0; t < moved.triangles.size(); ++t)
    for (size_t k = 0; k < 3; ++k)
      owner.emplace(edge_key(moved.triangles[t][k], moved.triangles[t][(k + 1) % 3]), t);
  uint32_t edges = 0;
  for (const uint32_t t : tree.sources()) {
    const auto& corners = moved.triangles[t];
    TriangleSeams s;
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t from = corners[k], to = corners[(k + 1) % 3];
      const auto other = owner.find(edge_key(to, from));
      s.beside[k] = other == owner.end() ? Vec3{0, 0, 0} : normals.triangles[other->second];
      s.at[k] = normals.vertices[from];
      const bool is_own = other == owner.end() || t < other->second;
      const Vec3 along = moved.vertices[to] - moved.vertices[from];
      s.edge[k] = is_own && is_sharp(normals.triangles[t], s.beside[k], along) ? edges++ : no_edge;
    }
    ground.seams.push_back(s);
  }
  ground.nodes = tree.nodes();
  ground.triangles = tree.triangles();
  return ground;
}

}  // namespace meniscus::collision
