// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes flat sheets, orients triangles, and finds closed meshes and connected parts.
#include "cloth/build/cloth_mesh.h"

#include <utility>

#include "cloth/build/topology.h"

namespace meniscus::cloth {

namespace {

// The triangle across each side of each triangle, and whether both face the same side.
struct Neighbour {
  uint32_t triangle;
  bool agrees;
};
using Neighbours = std::vector<std::vector<Neighbour>>;

Neighbours neighbours_of(const ClothMesh& mesh) {
  Neighbours neighbours(mesh.triangles.size());
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() != 2) return;
    const bool agrees = edge[0].forward != edge[1].forward;
    neighbours[edge[0].triangle].push_back({edge[1].triangle, agrees});
    neighbours[edge[1].triangle].push_back({edge[0].triangle, agrees});
  });
  return neighbours;
}

}  // namespace

ClothMesh make_sheet(float width, float depth, uint32_t columns, uint32_t rows) {
  ClothMesh mesh;
  for (uint32_t j = 0; j < rows; ++j) {
    for (uint32_t i = 0; i < columns; ++i) {
      const float u = width * static_cast<float>(i) / static_cast<float>(columns - 1);
      const float v = depth * static_cast<float>(j) / static_cast<float>(rows - 1);
      mesh.vertices.push_back({u - 0.5f * width, 0, v - 0.5f * depth});
      mesh.material.push_back({u, v});
    }
  }
  for (uint32_t j = 0; j + 1 < rows; ++j) {
    for (uint32_t i = 0; i + 1 < columns; ++i) {
      const uint32_t a = j * columns + i, b = a + 1, c = a + columns, d = c + 1;
      if (j % 2 == 0) {
        mesh.triangles.insert(mesh.triangles.end(), {{a, c, d}, {a, d, b}});
      } else {
        mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {b, c, d}});
      }
    }
  }
  return mesh;
}

void orient_triangles(ClothMesh& mesh) {
  const Neighbours neighbours = neighbours_of(mesh);
  std::vector<bool> taken(mesh.triangles.size()), turned(mesh.triangles.size());
  std::vector<uint32_t> part;
  for (uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (taken[seed]) continue;
    taken[seed] = true;
    part.assign(1, seed);
    for (size_t i = 0; i < part.size(); ++i) {
      for (const Neighbour& n : neighbours[part[i]]) {
        if (taken[n.triangle]) continue;
        taken[n.triangle] = true;
        turned[n.triangle] = turned[part[i]] == n.agrees;
        part.push_back(n.triangle);
      }
    }
  }
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (turned[t]) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
}

bool is_closed(const ClothMesh& mesh) {
  bool closed = !mesh.triangles.empty();
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    closed = closed && edge.size() == 2 && edge[0].forward != edge[1].forward;
  });
  return closed;
}

std::vector<uint32_t> connected_parts(const ClothMesh& mesh) {
  const VertexTriangles around(mesh);
  std::vector<uint32_t> part(mesh.vertices.size(), none), front;
  uint32_t parts = 0;
  for (uint32_t seed = 0; seed < part.size(); ++seed) {
    if (part[seed] != none) continue;
    part[seed] = parts;
    front.assign(1, seed);
    while (!front.empty()) {
      const uint32_t v = front.back();
      front.pop_back();
      for (uint32_t t : around.of(v)) {
        for (uint32_t w : mesh.triangles[t]) {
          if (std::exchange(part[w], parts) == none) front.push_back(w);
        }
      }
    }
    ++parts;
  }
  return part;
}

}  // namespace meniscus::cloth
