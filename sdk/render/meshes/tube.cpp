// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes the rings and triangles of tubes.
#include "sdk/render/meshes/tube.h"

#include <cmath>
#include <numbers>

namespace meniscus::render {
namespace {

constexpr int around = 12;

float angle_of(int k) {
  return 2 * std::numbers::pi_v<float> * static_cast<float>(k) / around;
}

struct Ring {
  Vec3 centre, along, across;
  float way;  ///< m along the line

  Vec3 normal(int k) const {
    const float angle = angle_of(k % around);
    return std::cos(angle) * across + std::sin(angle) * cross(along, across);
  }
};

/// One ring per point, across the bend there. Each ring continues the one before, so that the tube does not
/// twist.
std::vector<Ring> rings_of(std::span<const Vec3> line) {
  std::vector<Ring> rings;
  const std::size_t last = line.size() - 1;
  const bool closed = last > 1 && line.front() == line.back();
  Vec3 along{0, 1, 0}, across{1, 0, 0};
  float way = 0;
  for (std::size_t i = 0; i <= last; ++i) {
    const Vec3 before = i > 0 ? line[i - 1] : closed ? line[last - 1] : line[0];
    const Vec3 after = i < last ? line[i + 1] : closed ? line[1] : line[last];
    along = normalized_or(after - before, along);
    const Vec3 helper = std::abs(along.x) < 0.8f ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    across = normalized_or(i > 0 ? across - dot(across, along) * along : cross(along, helper),
                           cross(along, helper));
    if (i > 0) way += length(line[i] - line[i - 1]);
    rings.push_back({line[i], along, across, way});
  }
  return rings;
}

void add_end(Triangles& all, const Ring& ring, float radius, float side, Float4 color) {
  const Vec3 n = side * ring.along;
  for (int k = 0; k < around; ++k) {
    const Vec3 a = ring.centre + radius * ring.normal(k), b = ring.centre + radius * ring.normal(k + 1);
    for (const Vec3 corner : {ring.centre, side > 0 ? a : b, side > 0 ? b : a})
      all.push_back({corner, n, color, {}});
  }
}

}  // namespace

void add_tube(Triangles& triangles, std::span<const Vec3> line, float radius, Float4 color) {
  if (line.size() < 2) return;
  const std::vector<Ring> rings = rings_of(line);
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    const auto corner = [&](const Ring& ring, int k) {
      const Vec3 n = ring.normal(k);
      return Vertex{ring.centre + radius * n, n, color, {angle_of(k), ring.way / radius}};
    };
    for (int k = 0; k < around; ++k) {
      const Vertex a = corner(rings[i], k), b = corner(rings[i], k + 1);
      const Vertex c = corner(rings[i + 1], k), d = corner(rings[i + 1], k + 1);
      triangles.insert(triangles.end(), {a, b, c, b, d, c});
    }
  }
  if (line.front() == line.back()) return;
  add_end(triangles, rings.front(), radius, -1, color);
  add_end(triangles, rings.back(), radius, 1, color);
}

}  // namespace meniscus::render
