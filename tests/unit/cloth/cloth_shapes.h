// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Meshes for the tests of cloth.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "cloth/build/cloth_mesh.h"
#include "pbd/math/vec.h"

namespace meniscus::cloth {

/// A patch of equilateral triangles in the plane y = 0, in rows along x. Without material coordinates.
inline ClothMesh equilateral_patch(float edge, uint32_t columns, uint32_t rows) {
  ClothMesh mesh = make_sheet(1, 1, columns, rows);
  mesh.material.clear();
  const float height = edge * std::sqrt(0.75f);
  for (uint32_t j = 0; j < rows; ++j) {
    for (uint32_t i = 0; i < columns; ++i) {
      // Diagonals of even rows run from a to d, those of odd rows from b to c: see make_sheet.
      const float shift = j % 2 == 0 ? 0.0f : -0.5f;
      mesh.vertices[j * columns + i] = {edge * (static_cast<float>(i) + shift), 0,
                                        height * static_cast<float>(j)};
    }
  }
  return mesh;
}

/// An upright tube around the y axis. `around` vertices a ring, `rings` of them.
inline ClothMesh tube(float radius, float height, uint32_t around, uint32_t rings) {
  ClothMesh mesh;
  for (uint32_t j = 0; j < rings; ++j) {
    for (uint32_t i = 0; i < around; ++i) {
      const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(around);
      mesh.vertices.push_back({radius * std::cos(a),
                               height * static_cast<float>(j) / static_cast<float>(rings - 1),
                               radius * std::sin(a)});
    }
  }
  for (uint32_t j = 0; j + 1 < rings; ++j) {
    for (uint32_t i = 0; i < around; ++i) {
      const uint32_t a = j * around + i, b = j * around + (i + 1) % around, c = a + around, d = b + around;
      mesh.triangles.insert(mesh.triangles.end(), {{a, c, d}, {a, d, b}});
    }
  }
  return mesh;
}

/// Eight triangles, closed, facing outwards.
inline ClothMesh octahedron() {
  ClothMesh mesh;
  mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

/// The same surface with vertices and triangles in a random order.
inline ClothMesh shuffled(const ClothMesh& mesh, uint32_t seed) {
  std::mt19937 bits(seed);
  std::vector<uint32_t> number(mesh.vertices.size());
  for (uint32_t v = 0; v < number.size(); ++v) number[v] = v;
  std::shuffle(number.begin(), number.end(), bits);
  ClothMesh result = mesh;
  for (uint32_t v = 0; v < number.size(); ++v) {
    result.vertices[number[v]] = mesh.vertices[v];
    if (!mesh.material.empty()) result.material[number[v]] = mesh.material[v];
  }
  for (auto& t : result.triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
  std::shuffle(result.triangles.begin(), result.triangles.end(), bits);
  return result;
}

/// A sheet as from make_sheet, with its inner vertices displaced at random in its plane, by up to `way`.
inline ClothMesh jittered_sheet(uint32_t columns, uint32_t rows, float way, uint32_t seed) {
  ClothMesh mesh = make_sheet(1, 1, columns, rows);
  std::mt19937 bits(seed);
  const auto random = [&] { return way * (2 * static_cast<float>(bits() >> 8) / 16777216.0f - 1); };
  for (uint32_t j = 1; j + 1 < rows; ++j) {
    for (uint32_t i = 1; i + 1 < columns; ++i) mesh.vertices[j * columns + i] += Vec3{random(), 0, random()};
  }
  return mesh;
}

/// Where map(Vec3) takes the vertices.
template <class Map>
std::vector<Vec3> deformed(const ClothMesh& mesh, const Map& map) {
  std::vector<Vec3> x;
  for (Vec3 v : mesh.vertices) x.push_back(map(v));
  return x;
}

inline double area_of(const ClothMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    area += 0.5 * length(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
  }
  return area;
}

}  // namespace meniscus::cloth
