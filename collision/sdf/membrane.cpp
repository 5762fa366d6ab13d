// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds and meshes the membranes that close a mesh's holes.
#include "collision/sdf/membrane.h"

#include <cmath>
#include <unordered_map>

namespace meniscus::collision {

namespace {

uint32_t stride(const Lattice& lattice, uint32_t axis) {
  return axis == 0 ? 1 : axis == 1 ? lattice.nx : lattice.nx * lattice.ny;
}

bool has_next(const Lattice& lattice, uint32_t node, uint32_t axis) {
  if (axis == 0) return node % lattice.nx + 1 < lattice.nx;
  if (axis == 1) return node / lattice.nx % lattice.ny + 1 < lattice.ny;
  return node / lattice.nx / lattice.ny + 1 < lattice.nz;
}

// The four cells around an edge, named by their first node, in cyclic order.
std::array<uint32_t, 4> cells_around(const Lattice& lattice, MembraneEdge edge) {
  const uint32_t a = stride(lattice, (edge.axis + 1) % 3), b = stride(lattice, (edge.axis + 2) % 3);
  return {edge.node, edge.node - a, edge.node - a - b, edge.node - b};
}

Vec3 crossing(const Lattice& lattice, MembraneEdge edge, float fraction) {
  const Vec3 from = lattice.point(edge.node), to = lattice.point(edge.node + stride(lattice, edge.axis));
  return from + fraction * (to - from);
}

// One vertex per cell, at the mean of the points added to it.
class CellVertices {
 public:
  uint32_t add(uint32_t cell, Vec3 crossing) {
    const auto next = static_cast<uint32_t>(sums_.size());
    const uint32_t vertex = numbers_.try_emplace(cell, next).first->second;
    if (vertex == next) {
      sums_.push_back({0, 0, 0});
      counts_.push_back(0);
    }
    sums_[vertex] += crossing;
    counts_[vertex] += 1;
    return vertex;
  }

  std::vector<Vec3> means() const {
    std::vector<Vec3> means;
    for (size_t v = 0; v < sums_.size(); ++v) means.push_back(sums_[v] / counts_[v]);
    return means;
  }

 private:
  std::unordered_map<uint32_t, uint32_t> numbers_;
  std::vector<Vec3> sums_;
  std::vector<float> counts_;
};

}  // namespace

std::vector<MembraneEdge> membrane_edges(const Lattice& lattice, std::span<const float> distances) {
  // If a triangle passes between two nodes, their distances to it sum to one edge at most. The excess allows
  // for rounding.
  const float longest = 1.001f * lattice.spacing;
  std::vector<MembraneEdge> edges;
  for (uint32_t node = 0; node < lattice.count(); ++node) {
    for (uint32_t axis = 0; axis < 3; ++axis) {
      if (!has_next(lattice, node, axis)) continue;
      const float a = distances[node], b = distances[node + stride(lattice, axis)];
      if ((a < 0) != (b < 0) && std::fabs(a) + std::fabs(b) > longest) edges.push_back({node, axis});
    }
  }
  return edges;
}

TriangleMesh membrane_mesh(const Lattice& lattice, std::span<const MembraneEdge> edges,
                           std::span<const float> fractions) {
  CellVertices vertices;
  TriangleMesh mesh;
  for (size_t e = 0; e < edges.size(); ++e) {
    const Vec3 point = crossing(lattice, edges[e], fractions[e]);
    std::array<uint32_t, 4> ring = cells_around(lattice, edges[e]);
    for (uint32_t& corner : ring) corner = vertices.add(corner, point);
    mesh.triangles.push_back({ring[0], ring[1], ring[2]});
    mesh.triangles.push_back({ring[0], ring[2], ring[3]});
  }
  mesh.vertices = vertices.means();
  return mesh;
}

}  // namespace meniscus::collision
