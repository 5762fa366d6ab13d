// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/world/container_walls.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pbd/math/vec.h"

namespace meniscus {

namespace {

using Point = std::array<float, 3>;

Point to_array(Vec3 v) {
  return {v.x, v.y, v.z};
}

/// One face: its axis and side, and the holes in it.
struct Wall {
  int axis;
  bool high;
  std::vector<Aabb> holes;
  bool open = false;
};

Wall wall_of(const ContainerGeometry& container, int face) {
  Wall wall{face / 2, face % 2 == 1, {}, false};
  for (const Opening& opening : container.openings) {
    if (static_cast<int>(opening.face) != face) continue;
    if (opening.region) wall.holes.push_back(*opening.region);
    wall.open |= !opening.region;
  }
  return wall;
}

/// Where rectangles that leave the holes free may begin and end, along one axis.
std::vector<float> cuts(const Wall& wall, int axis, float half) {
  std::vector<float> at{-half, half};
  for (const Aabb& hole : wall.holes) {
    at.push_back(std::clamp(to_array(hole.lower)[axis], -half, half));
    at.push_back(std::clamp(to_array(hole.upper)[axis], -half, half));
  }
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end()), at.end());
  return at;
}

bool in_hole(const Wall& wall, int u, int v, float at_u, float at_v) {
  return std::any_of(wall.holes.begin(), wall.holes.end(), [&](const Aabb& hole) {
    const Point lower = to_array(hole.lower), upper = to_array(hole.upper);
    return at_u > lower[u] && at_u < upper[u] && at_v > lower[v] && at_v < upper[v];
  });
}

}  // namespace

std::vector<collision::RigidPart> container_walls(const ContainerGeometry& container) {
  const Point half = to_array(container.half_extents);
  const float thickness = *std::max_element(half.begin(), half.end());
  std::vector<collision::RigidPart> parts;
  for (int face = 0; face < 6; ++face) {
    const Wall wall = wall_of(container, face);
    if (wall.open) continue;
    const int u = (wall.axis + 1) % 3, v = (wall.axis + 2) % 3;
    // Walls reach past the corners, so that none of them is a gap.
    const std::vector<float> along_u = cuts(wall, u, half[u] + thickness),
                             along_v = cuts(wall, v, half[v] + thickness);
    for (size_t i = 0; i + 1 < along_u.size(); ++i) {
      for (size_t j = 0; j + 1 < along_v.size(); ++j) {
        Point centre{}, extent{};
        centre[u] = 0.5f * (along_u[i] + along_u[i + 1]);
        centre[v] = 0.5f * (along_v[j] + along_v[j + 1]);
        if (in_hole(wall, u, v, centre[u], centre[v])) continue;
        centre[wall.axis] = (wall.high ? 1.0f : -1.0f) * (half[wall.axis] + 0.5f * thickness);
        extent[u] = 0.5f * (along_u[i + 1] - along_u[i]);
        extent[v] = 0.5f * (along_v[j + 1] - along_v[j]);
        extent[wall.axis] = 0.5f * thickness;
        collision::RigidPart part;
        part.pose.position = {centre[0], centre[1], centre[2]};
        part.size = {extent[0], extent[1], extent[2]};
        parts.push_back(part);
      }
    }
  }
  return parts;
}

}  // namespace meniscus
