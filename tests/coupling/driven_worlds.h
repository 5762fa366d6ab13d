// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Driven surfaces for tests.
#pragma once

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "tests/cloth_worlds.h"

namespace meniscus::tests {

/// The mesh of a piece of cloth as it is made.
struct PieceMesh {
  std::vector<Vec3> vertices;
  std::vector<uint32_t> triangles;
};

inline PieceMesh mesh_of(const ClothGeometry& geometry) {
  World world;
  ClothDef def;
  def.name = "mesh";
  def.geometry = geometry;
  const ClothId id = world.create_cloth(def);
  const auto x = world.cloth_positions(id);
  const auto t = world.cloth_triangles(id);
  return {{x.begin(), x.end()}, {t.begin(), t.end()}};
}

inline std::vector<Vec3> moved_by(std::vector<Vec3> points, Vec3 way) {
  for (Vec3& p : points) p += way;
  return points;
}

/// A mesh that goes from one place to another, and stays there.
inline ClothDef driven(const PieceMesh& mesh, Vec3 from, Vec3 to, float start, float end) {
  ClothDef def;
  def.name = "driven";
  DrivenTriangles motion;
  motion.triangles = mesh.triangles;
  motion.keyframes = {{start, moved_by(mesh.vertices, from)}, {end, moved_by(mesh.vertices, to)}};
  def.geometry = motion;
  return def;
}

/// A file in the format OBJ.
inline std::string obj_text(const std::vector<Vec3>& vertices, const std::vector<uint32_t>& triangles) {
  std::string text;
  char line[128];
  for (const Vec3 v : vertices) {
    std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", double{v.x}, double{v.y}, double{v.z});
    text += line;
  }
  for (size_t t = 0; t < triangles.size(); t += 3)
    text += "f " + std::to_string(triangles[t] + 1) + " " + std::to_string(triangles[t + 1] + 1) + " " +
            std::to_string(triangles[t + 2] + 1) + "\n";
  return text;
}

}  // namespace meniscus::tests
