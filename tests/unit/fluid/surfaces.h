// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Measurements of surfaces for tests.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "pbd/math/vec.h"

namespace meniscus::tests {

using Triangles = std::span<const std::array<uint32_t, 3>>;

/// Edges that are not in two triangles, once in each direction.
inline size_t open_edges(Triangles triangles) {
  std::map<std::pair<uint32_t, uint32_t>, std::pair<int, int>> edges;
  for (const auto& t : triangles) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = t[k], b = t[(k + 1) % 3];
      auto& [forth, back] = edges[std::minmax(a, b)];
      ++(a < b ? forth : back);
    }
  }
  size_t open = 0;
  for (const auto& [edge, uses] : edges) open += uses != std::pair{1, 1};
  return open;
}

/// Vertices around which the triangles are not one ring.
inline size_t broken_rings(Triangles triangles) {
  std::map<uint32_t, std::map<uint32_t, uint32_t>> next;  // around a vertex, from one neighbour to another
  for (const auto& t : triangles) {
    for (size_t k = 0; k < 3; ++k) next[t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3];
  }
  size_t broken = 0;
  for (const auto& [vertex, ring] : next) {
    size_t steps = 0;
    uint32_t at = ring.begin()->first;
    do {
      const auto found = ring.find(at);
      if (found == ring.end()) break;
      at = found->second;
      ++steps;
    } while (at != ring.begin()->first && steps <= ring.size());
    broken += steps != ring.size();
  }
  return broken;
}

inline double volume_inside(std::span<const Vec3> vertices, Triangles triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vec3 u = vertices[a], v = vertices[b], w = vertices[c];
    sum += double{u.x} * (double{v.y} * w.z - double{v.z} * w.y) +
           double{u.y} * (double{v.z} * w.x - double{v.x} * w.z) +
           double{u.z} * (double{v.x} * w.y - double{v.y} * w.x);
  }
  return sum / 6;
}

}  // namespace meniscus::tests
