// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds with cloth for tests, and measurements of that cloth.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "tests/worlds.h"

namespace meniscus::tests {

inline constexpr float unyielding = std::numeric_limits<float>::infinity();

/// A sheet in the plane y = 0 about a point.
inline ClothDef sheet(float width, float depth, int columns, int rows, Vec3 position = {0, 0, 0}) {
  ClothDef def;
  def.name = "sheet";
  def.geometry = SheetGeometry{width, depth, columns, rows};
  def.pose.position = position;
  return def;
}

inline RopeDef rope(std::vector<Vec3> points, int segments) {
  RopeDef def;
  def.name = "rope";
  def.points = std::move(points);
  def.segments = segments;
  return def;
}

inline AttachmentDef attach(ClothId cloth, std::vector<uint32_t> vertices) {
  AttachmentDef def;
  def.name = "attachment";
  def.cloth = cloth;
  def.vertices = std::move(vertices);
  return def;
}

inline AttachmentDef attach(RopeId id, std::vector<uint32_t> vertices) {
  AttachmentDef def;
  def.name = "attachment";
  def.rope = id;
  def.vertices = std::move(vertices);
  return def;
}

/// first, first + 1 and so on.
inline std::vector<uint32_t> vertices_from(uint32_t first, uint32_t count) {
  std::vector<uint32_t> all;
  for (uint32_t v = 0; v < count; ++v) all.push_back(first + v);
  return all;
}

/// Of each edge, its length over that at rest, ascending.
inline std::vector<double> edge_stretches(const World& world, ClothId id, std::span<const Vec3> rest) {
  std::map<std::pair<uint32_t, uint32_t>, double> edges;
  const auto x = world.cloth_positions(id);
  const auto triangles = world.cloth_triangles(id);
  for (size_t t = 0; t < triangles.size(); t += 3) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = triangles[t + k], b = triangles[t + (k + 1) % 3];
      edges[std::minmax(a, b)] = double{length(x[b] - x[a])} / double{length(rest[b] - rest[a])};
    }
  }
  std::vector<double> stretches;
  for (const auto& [edge, stretch] : edges) stretches.push_back(stretch);
  std::sort(stretches.begin(), stretches.end());
  return stretches;
}

inline double percentile(const std::vector<double>& ascending, double share) {
  return ascending[static_cast<size_t>(share * static_cast<double>(ascending.size() - 1))];
}

inline double rms_speed(const World& world, ClothId id) {
  double sum = 0;
  const auto v = world.cloth_velocities(id);
  for (Vec3 u : v) sum += double{dot(u, u)};
  return std::sqrt(sum / static_cast<double>(v.size()));
}

inline std::vector<Vec3> copy_of(std::span<const Vec3> values) {
  return {values.begin(), values.end()};
}

}  // namespace meniscus::tests
