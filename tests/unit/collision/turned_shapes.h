// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Closed meshes of concave solids for tests: rings and bowls, turned about the y axis.
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// Turns a closed profile of points (distance from the axis, height) about y. The profile runs such that the
/// solid is on its left, with the distance to the right and the height upwards.
inline TriangleMesh turned_mesh(const std::vector<std::array<float, 2>>& profile, uint32_t around) {
  TriangleMesh mesh;
  const auto m = static_cast<uint32_t>(profile.size());
  for (uint32_t i = 0; i < around; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(around);
    for (const auto& [r, y] : profile) mesh.vertices.push_back({r * std::cos(angle), y, r * std::sin(angle)});
    for (uint32_t j = 0; j < m; ++j) {
      const uint32_t a = i * m + j, b = i * m + (j + 1) % m;
      const uint32_t c = (i + 1) % around * m + j, d = (i + 1) % around * m + (j + 1) % m;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({b, d, c});
    }
  }
  return mesh;
}

/// A torus about y.
inline TriangleMesh ring_mesh(float radius, float thickness, uint32_t around = 32, uint32_t across = 12) {
  std::vector<std::array<float, 2>> profile;
  for (uint32_t j = 0; j < across; ++j) {
    const float angle = 6.2831853f * static_cast<float>(j) / static_cast<float>(across);
    profile.push_back({radius + thickness * std::cos(angle), thickness * std::sin(angle)});
  }
  return turned_mesh(profile, around);
}

/// The lower half of a hollow ball around the origin, with a small hole at its bottom.
inline TriangleMesh bowl_mesh(float outer, float inner, uint32_t around = 32, uint32_t down = 10) {
  std::vector<std::array<float, 2>> profile;
  const auto arc = [&](float radius, uint32_t j) {
    const float angle = 1.5707963f * (0.04f + 0.96f * static_cast<float>(j) / static_cast<float>(down));
    profile.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
  };
  for (uint32_t j = 0; j <= down; ++j) arc(outer, j);
  for (uint32_t j = down + 1; j-- > 0;) arc(inner, j);
  return turned_mesh(profile, around);
}

inline std::string obj_of(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(9);
  for (const Vec3 v : mesh.vertices) text << "v " << v.x << ' ' << v.y << ' ' << v.z << '\n';
  for (const auto& t : mesh.triangles) text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  return text.str();
}

}  // namespace meniscus::collision
