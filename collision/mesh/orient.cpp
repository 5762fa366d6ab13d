// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Orients the faces of meshes.
#include "collision/mesh/orient.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "collision/mesh/triangle_bvh_query.h"
#include "pbd/math/vec.h"
#include "pbd/mesh_edges.h"

namespace meniscus::collision {

using pbd::edge_uses;
using pbd::EdgeUse;
using pbd::for_each_edge;

namespace {

constexpr uint32_t none = 0xffffffff;

// The face across an edge that two faces share.
struct Neighbour {
  uint32_t face = none;
  bool agrees = false;  // whether both have the same orientation
};

using Neighbours = std::vector<std::array<Neighbour, 3>>;

Neighbours neighbours_of(size_t faces, std::span<const EdgeUse> uses) {
  Neighbours neighbours(faces);
  const auto link = [&](uint32_t face, Neighbour other) {
    auto& row = neighbours[face];
    *std::find_if(row.begin(), row.end(), [](const Neighbour& n) { return n.face == none; }) = other;
  };
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() != 2) return;
    const bool agrees = edge[0].forward != edge[1].forward;
    link(edge[0].triangle, {edge[1].triangle, agrees});
    link(edge[1].triangle, {edge[0].triangle, agrees});
  });
  return neighbours;
}

void turn(TriangleMesh& mesh, uint32_t face) {
  std::swap(mesh.triangles[face][1], mesh.triangles[face][2]);
}

// The faces that are connected with `seed`, and whether each must be flipped to agree with it.
struct Part {
  std::vector<uint32_t> faces;
  std::vector<bool> turned;
};

Part part_around(uint32_t seed, const Neighbours& neighbours, std::vector<bool>& taken) {
  Part part{{seed}, {false}};
  taken[seed] = true;
  for (size_t i = 0; i < part.faces.size(); ++i) {
    for (const Neighbour& n : neighbours[part.faces[i]]) {
      if (n.face == none || taken[n.face]) continue;
      taken[n.face] = true;
      part.faces.push_back(n.face);
      part.turned.push_back(part.turned[i] == n.agrees);
    }
  }
  return part;
}

// Flips the faces of the smaller group.
void make_agree(TriangleMesh& mesh, const Part& part) {
  const auto turned = std::count(part.turned.begin(), part.turned.end(), true);
  const bool minority = 2 * static_cast<size_t>(turned) <= part.turned.size();
  for (size_t i = 0; i < part.faces.size(); ++i) {
    if (part.turned[i] == minority) turn(mesh, part.faces[i]);
  }
}

// A connected part as a mesh of its own.
struct Shell {
  std::vector<uint32_t> faces;
  TriangleMesh mesh;  // with all the vertices of the part, and no others
  Aabb box;
  std::optional<TriangleBvh> tree;  // built at its first use
};

TriangleMesh part_mesh(const TriangleMesh& whole, const std::vector<uint32_t>& faces) {
  std::vector<uint32_t> used;
  for (uint32_t f : faces) used.insert(used.end(), whole.triangles[f].begin(), whole.triangles[f].end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  TriangleMesh part;
  for (uint32_t v : used) part.vertices.push_back(whole.vertices[v]);
  for (uint32_t f : faces) {
    std::array<uint32_t, 3> corners = whole.triangles[f];
    for (uint32_t& v : corners) {
      v = static_cast<uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    }
    part.triangles.push_back(corners);
  }
  return part;
}

bool is_closed(const TriangleMesh& mesh) {
  bool closed = true;
  for_each_edge(edge_uses(mesh), [&](std::span<const EdgeUse> edge) {
    closed = closed && edge.size() == 2 && edge[0].forward != edge[1].forward;
  });
  return closed;
}

bool holds(const Aabb& outer, const Aabb& inner) {
  return max_component(outer.lower - inner.lower) < 0 && max_component(inner.upper - outer.upper) < 0;
}

bool lies_inside(const Shell& inner, Shell& outer) {
  if (!holds(outer.box, inner.box)) return false;
  if (!outer.tree) outer.tree.emplace(outer.mesh);
  const TriangleBvhView tree = outer.tree->view();
  return std::all_of(inner.mesh.vertices.begin(), inner.mesh.vertices.end(),
                     [&](Vec3 v) { return is_inside(tree, v); });
}

void face_outwards(TriangleMesh& mesh, std::vector<Shell>& shells) {
  for (const Shell& shell : shells) {
    bool outwards = true;
    for (Shell& other : shells) {
      if (&other != &shell && lies_inside(shell, other)) outwards = !outwards;
    }
    if ((signed_volume(shell.mesh) > 0) == outwards) continue;
    for (uint32_t f : shell.faces) turn(mesh, f);
  }
}

}  // namespace

void orient_faces(TriangleMesh& mesh) {
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  const Neighbours neighbours = neighbours_of(mesh.triangles.size(), uses);
  std::vector<bool> taken(mesh.triangles.size());
  std::vector<Shell> shells;
  for (uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (taken[seed]) continue;
    Part part = part_around(seed, neighbours, taken);
    make_agree(mesh, part);
    TriangleMesh alone = part_mesh(mesh, part.faces);
    if (!is_closed(alone)) continue;
    const Aabb box = bounds(alone);
    shells.push_back({std::move(part.faces), std::move(alone), box, std::nullopt});
  }
  face_outwards(mesh, shells);
}

}  // namespace meniscus::collision
