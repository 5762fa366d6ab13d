// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds vertices within a distance in cells of that width, and merges them.
#include "cloth/build/weld.h"

#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace meniscus::cloth {

namespace {

using Cell = std::array<int64_t, 3>;

bool less(Vec3 a, Vec3 b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

bool within(Vec3 a, Vec3 b, double distance) {
  const double x = double{a.x} - b.x, y = double{a.y} - b.y, z = double{a.z} - b.z;
  return x * x + y * y + z * z <= distance * distance;
}

/// Sets of vertices. A set's root is its vertex with the least position.
class Sets {
 public:
  explicit Sets(const std::vector<Vec3>& vertices) : vertices_(vertices), parent_(vertices.size()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  uint32_t root(uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  void join(uint32_t a, uint32_t b) {
    a = root(a);
    b = root(b);
    if (less(vertices_[b], vertices_[a])) std::swap(a, b);
    parent_[b] = a;
  }

 private:
  const std::vector<Vec3>& vertices_;
  std::vector<uint32_t> parent_;
};

Cell cell_of(Vec3 x, double width) {
  const auto along = [&](float a) { return static_cast<int64_t>(std::floor(double{a} / width)); };
  return {along(x.x), along(x.y), along(x.z)};
}

void join_near(const std::vector<Vec3>& vertices, double distance, Sets& sets) {
  std::map<Cell, std::vector<uint32_t>> cells;
  for (uint32_t v = 0; v < vertices.size(); ++v) {
    const Cell c = cell_of(vertices[v], distance);
    for (int k = 0; k < 27; ++k) {
      const auto found = cells.find({c[0] + k % 3 - 1, c[1] + k / 3 % 3 - 1, c[2] + k / 9 - 1});
      if (found == cells.end()) continue;
      for (uint32_t u : found->second) {
        if (within(vertices[u], vertices[v], distance)) sets.join(u, v);
      }
    }
    cells[c].push_back(v);
  }
}

}  // namespace

uint32_t weld(ClothMesh& mesh, double distance, std::vector<uint32_t>* dropped) {
  if (!(distance > 0)) return 0;
  const std::vector<Vec3> old = std::move(mesh.vertices);
  Sets sets(old);
  join_near(old, distance, sets);
  mesh.vertices.clear();
  std::map<uint32_t, uint32_t> of_root;
  std::vector<uint32_t> number(old.size());
  for (uint32_t v = 0; v < old.size(); ++v) {
    const uint32_t root = sets.root(v);
    const auto [found, is_new] = of_root.emplace(root, static_cast<uint32_t>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(old[root]);
    number[v] = found->second;
  }
  for (auto& t : mesh.triangles) {
    for (uint32_t& v : t) v = v < number.size() ? number[v] : v;
  }
  const auto lost_a_corner = [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
  for (uint32_t t = 0; dropped && t < mesh.triangles.size(); ++t) {
    if (lost_a_corner(mesh.triangles[t])) dropped->push_back(t);
  }
  std::erase_if(mesh.triangles, lost_a_corner);
  return static_cast<uint32_t>(old.size() - mesh.vertices.size());
}

}  // namespace meniscus::cloth
