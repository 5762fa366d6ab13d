// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Welds vertices and drops degenerate, repeated and unused parts of a mesh.
#include "collision/mesh/clean.h"
#include "collision/mesh/tuning.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace meniscus::collision {

namespace {

using Corners = std::array<uint32_t, 3>;

constexpr uint32_t none = 0xffffffff;

struct DoubleVec {
  double x, y, z;
};

DoubleVec difference(Vec3 a, Vec3 b) {
  return {double{a.x} - b.x, double{a.y} - b.y, double{a.z} - b.z};
}
double squared(const DoubleVec& a) {
  return a.x * a.x + a.y * a.y + a.z * a.z;
}

// Vertices kept so far, in cells as wide as the welding distance. A vertex to weld with is in one of 27
// cells.
class Welder {
 public:
  Welder(const std::vector<Vec3>& vertices, const Aabb& box)
      : vertices_(vertices),
        lower_(box.lower),
        reach_(mesh_tuning::weld_distance * std::sqrt(squared(difference(box.upper, box.lower)))) {
    next_.resize(vertices.size(), none);
  }

  /// The first vertex kept within reach of vertex i, or i itself, which is then kept.
  uint32_t weld(uint32_t i) {
    const Vec3 p = vertices_[i];
    const std::array<int64_t, 3> cell = cell_of(p);
    if (const uint32_t self = find(p, key(cell, 0, 0, 0)); self != none) return self;
    for (int z = -1; z <= 1; ++z) {
      for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
          if (const uint32_t near = find(p, key(cell, x, y, z)); near != none) return near;
        }
      }
    }
    auto [head, fresh] = heads_.try_emplace(key(cell, 0, 0, 0), i);
    if (!fresh) next_[i] = std::exchange(head->second, i);
    return i;
  }

 private:
  std::array<int64_t, 3> cell_of(Vec3 p) const {
    if (reach_ == 0) return {0, 0, 0};
    const auto along = [&](float a, float lower) {
      return static_cast<int64_t>((double{a} - lower) / reach_) + 1;
    };
    return {along(p.x, lower_.x), along(p.y, lower_.y), along(p.z, lower_.z)};
  }

  // The number of a cell stays below 2^21, because the diagonal is a million cells long.
  static uint64_t key(const std::array<int64_t, 3>& cell, int x, int y, int z) {
    return static_cast<uint64_t>(cell[0] + x) | static_cast<uint64_t>(cell[1] + y) << 21 |
           static_cast<uint64_t>(cell[2] + z) << 42;
  }

  uint32_t find(Vec3 p, uint64_t cell) const {
    const auto head = heads_.find(cell);
    if (head == heads_.end()) return none;
    for (uint32_t j = head->second; j != none; j = next_[j]) {
      if (squared(difference(vertices_[j], p)) <= reach_ * reach_) return j;
    }
    return none;
  }

  const std::vector<Vec3>& vertices_;
  Vec3 lower_;
  double reach_;
  std::unordered_map<uint64_t, uint32_t> heads_;
  std::vector<uint32_t> next_;
};

std::vector<uint32_t> weld_all(const TriangleMesh& mesh) {
  Welder welder(mesh.vertices, bounds(mesh));
  std::vector<uint32_t> kept(mesh.vertices.size());
  for (uint32_t i = 0; i < kept.size(); ++i) kept[i] = welder.weld(i);
  return kept;
}

bool is_flat(Vec3 a, Vec3 b, Vec3 c) {
  const DoubleVec ab = difference(b, a), ac = difference(c, a), bc = difference(c, b);
  const DoubleVec n{ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x};
  const double longest = std::max({squared(ab), squared(ac), squared(bc)});
  return squared(n) <= mesh_tuning::flat_height * mesh_tuning::flat_height * longest * longest;
}

// The same triangle with its smallest corner first, so that equal triangles compare equal. Its orientation
// stays.
Corners turned(Corners t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

// The first of each set of equal triangles, in their old order.
std::vector<uint32_t> without_repeats(const std::vector<Corners>& triangles) {
  std::vector<std::pair<Corners, uint32_t>> sorted;
  for (uint32_t i = 0; i < triangles.size(); ++i) sorted.emplace_back(turned(triangles[i]), i);
  std::sort(sorted.begin(), sorted.end());
  const auto end =
      std::unique(sorted.begin(), sorted.end(), [](auto& a, auto& b) { return a.first == b.first; });
  std::vector<uint32_t> kept;
  for (auto entry = sorted.begin(); entry != end; ++entry) kept.push_back(entry->second);
  std::sort(kept.begin(), kept.end());
  return kept;
}

// Renumbers the used vertices, in their old order. `sources` gets their old numbers.
TriangleMesh compact(const std::vector<Vec3>& vertices, std::vector<Corners> triangles,
                     std::vector<uint32_t>& sources) {
  std::vector<uint32_t> number(vertices.size(), none);
  for (const Corners& t : triangles) {
    for (uint32_t v : t) number[v] = 0;
  }
  TriangleMesh result;
  for (uint32_t v = 0; v < vertices.size(); ++v) {
    if (number[v] == none) continue;
    number[v] = static_cast<uint32_t>(result.vertices.size());
    result.vertices.push_back(vertices[v]);
    sources.push_back(v);
  }
  for (Corners& t : triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
  result.triangles = std::move(triangles);
  return result;
}

// Places whose vertices were merged into another one's. Files that repeat a vertex for each face have none.
size_t count_merged(const std::vector<Vec3>& vertices, const std::vector<uint32_t>& kept) {
  std::vector<std::array<float, 3>> merged;
  for (uint32_t i = 0; i < kept.size(); ++i) {
    const Vec3 p = vertices[i];
    if (squared(difference(vertices[kept[i]], p)) > 0) merged.push_back({p.x, p.y, p.z});
  }
  std::sort(merged.begin(), merged.end());
  return static_cast<size_t>(std::unique(merged.begin(), merged.end()) - merged.begin());
}

}  // namespace

CleanedMesh clean_mesh_with_sources(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return {};
  const std::vector<uint32_t> kept = weld_all(mesh);
  std::vector<Corners> welded;
  std::vector<uint32_t> sources;
  for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners& t = mesh.triangles[i];
    const Corners corners{kept[t[0]], kept[t[1]], kept[t[2]]};
    const auto& v = mesh.vertices;
    if (is_flat(v[corners[0]], v[corners[1]], v[corners[2]])) continue;
    welded.push_back(corners);
    sources.push_back(i);
  }
  CleanedMesh result;
  std::vector<Corners> triangles;
  for (uint32_t i : without_repeats(welded)) {
    triangles.push_back(welded[i]);
    result.sources.push_back(sources[i]);
  }
  result.welded = count_merged(mesh.vertices, kept);
  result.dropped = mesh.triangles.size() - triangles.size();
  result.mesh = compact(mesh.vertices, std::move(triangles), result.vertex_sources);
  return result;
}

TriangleMesh clean_mesh(const TriangleMesh& mesh) {
  return clean_mesh_with_sources(mesh).mesh;
}

}  // namespace meniscus::collision
