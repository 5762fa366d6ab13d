// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes the meshes of spheres and tubes.
#include "sdk/world/cloth/cloth_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "pbd/math/vec.h"

namespace meniscus {
namespace {

constexpr float golden = std::numbers::phi_v<float>;
constexpr Vec3 icosahedron[12] = {{-1, golden, 0}, {1, golden, 0}, {-1, -golden, 0}, {1, -golden, 0},
                                  {0, -1, golden}, {0, 1, golden}, {0, -1, -golden}, {0, 1, -golden},
                                  {golden, 0, -1}, {golden, 0, 1}, {-golden, 0, -1}, {-golden, 0, 1}};
constexpr int icosahedron_faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                          {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                          {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                          {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};

/// Divides the faces of an icosahedron, and projects the vertices onto the sphere.
class Geodesic {
 public:
  explicit Geodesic(const ClothSphere& sphere) : sphere_(sphere) {}

  cloth::ClothMesh mesh() {
    for (const auto& face : icosahedron_faces) divide(face);
    return std::move(mesh_);
  }

 private:
  /// A vertex's weights with respect to the icosahedron's corners, in the order of the corners. Several faces
  /// share the vertices on an edge or a corner; equal weights identify them.
  using Weights = std::array<std::pair<int, int>, 3>;

  void divide(const int (&face)[3]) {
    const int n = sphere_.divisions;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        const uint32_t a = vertex(face, i, j), b = vertex(face, i + 1, j), c = vertex(face, i, j + 1);
        mesh_.triangles.push_back({a, b, c});
        if (i + j + 1 < n) mesh_.triangles.push_back({b, vertex(face, i + 1, j + 1), c});
      }
    }
  }

  /// The vertex that is i steps from the face's first corner towards its second, and j towards its third.
  uint32_t vertex(const int (&face)[3], int i, int j) {
    Weights weights{{{face[0], sphere_.divisions - i - j}, {face[1], i}, {face[2], j}}};
    for (auto& [corner, weight] : weights) {
      if (weight == 0) corner = -1;
    }
    std::sort(weights.begin(), weights.end());
    const auto [found, is_new] = numbers_.emplace(weights, static_cast<uint32_t>(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.push_back(on_sphere(weights));
    return found->second;
  }

  Vec3 on_sphere(const Weights& weights) const {
    Vec3 sum{0, 0, 0};
    for (const auto& [corner, weight] : weights) {
      if (corner >= 0) sum += static_cast<float>(weight) * icosahedron[corner];
    }
    return sphere_.radius / length(sum) * sum;
  }

  const ClothSphere& sphere_;
  cloth::ClothMesh mesh_;
  std::map<Weights, uint32_t> numbers_;
};

/// A disc that joins a mesh's last vertices, which go around its border. It consists of rings with about
/// equal edge lengths, and ever fewer vertices.
class Disc {
 public:
  Disc(cloth::ClothMesh& mesh, float radius, float height, uint32_t columns)
      : mesh_(mesh), radius_(radius), height_(height), columns_(columns) {}

  void add() {
    const int rings = std::max(1, static_cast<int>(std::lround(static_cast<float>(columns_) / two_pi)));
    Ring outer{static_cast<uint32_t>(mesh_.vertices.size()) - columns_, columns_};
    for (int k = 1; k <= rings; ++k) {
      const float fraction = 1 - static_cast<float>(k) / static_cast<float>(rings);
      const Ring inner = add_ring(fraction);
      join(outer, inner);
      outer = inner;
    }
  }

 private:
  struct Ring {
    uint32_t first, count;

    uint32_t vertex(uint32_t k) const { return first + k % count; }
  };

  static constexpr float two_pi = 2 * std::numbers::pi_v<float>;

  /// The ring at a fraction of the radius; the last one is a single vertex.
  Ring add_ring(float fraction) {
    const auto around = static_cast<uint32_t>(std::lround(fraction * static_cast<float>(columns_)));
    const Ring ring{static_cast<uint32_t>(mesh_.vertices.size()), fraction > 0 ? std::max(3u, around) : 1};
    for (uint32_t k = 0; k < ring.count; ++k) {
      const float angle = two_pi * static_cast<float>(k) / static_cast<float>(ring.count),
                  r = fraction * radius_;
      mesh_.vertices.push_back({r * std::cos(angle), height_, r * std::sin(angle)});
    }
    return ring;
  }

  /// Walks around both rings at once, and always advances on the one that lags behind.
  void join(const Ring& outer, const Ring& inner) {
    const uint32_t steps = inner.count > 1 ? inner.count : 0;
    for (uint32_t o = 0, i = 0; o < outer.count || i < steps;) {
      if (uint64_t{2 * o + 1} * std::max(1u, steps) <= uint64_t{2 * i + 1} * outer.count || i == steps) {
        mesh_.triangles.push_back({outer.vertex(o), outer.vertex(o + 1), inner.vertex(i)});
        ++o;
      } else {
        mesh_.triangles.push_back({outer.vertex(o), inner.vertex(i + 1), inner.vertex(i)});
        ++i;
      }
    }
  }

  cloth::ClothMesh& mesh_;
  float radius_, height_;
  uint32_t columns_;
};

}  // namespace

cloth::ClothMesh sphere_mesh(const ClothSphere& sphere) {
  return Geodesic(sphere).mesh();
}

cloth::ClothMesh tube_mesh(const ClothTube& tube) {
  cloth::ClothMesh mesh;
  const auto columns = static_cast<uint32_t>(tube.columns), rows = static_cast<uint32_t>(tube.rows);
  for (uint32_t row = 0; row < rows; ++row) {
    const float down = static_cast<float>(row) / static_cast<float>(rows - 1);
    const float radius = tube.top_radius + down * (tube.bottom_radius - tube.top_radius);
    for (uint32_t column = 0; column < columns; ++column) {
      const float angle =
          2 * std::numbers::pi_v<float> * static_cast<float>(column) / static_cast<float>(columns);
      mesh.vertices.push_back(
          {radius * std::cos(angle), (0.5f - down) * tube.height, radius * std::sin(angle)});
    }
  }
  for (uint32_t row = 0; row + 1 < rows; ++row) {
    for (uint32_t column = 0; column < columns; ++column) {
      const uint32_t right = (column + 1) % columns, top = row * columns, bottom = top + columns;
      const uint32_t a = top + column, b = top + right, c = bottom + column, d = bottom + right;
      // Diagonals alternate from row to row, as in a sheet.
      if (row % 2 == 0) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({b, d, c});
      } else {
        mesh.triangles.push_back({a, d, c});
        mesh.triangles.push_back({a, b, d});
      }
    }
  }
  if (tube.bottom) Disc(mesh, tube.bottom_radius, -0.5f * tube.height, columns).add();
  return mesh;
}

}  // namespace meniscus
