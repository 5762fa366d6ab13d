// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Splits vertices of a mesh along planes.
#include "cloth/build/tearing.h"

#include <meniscus/error.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "cloth/build/topology.h"
#include "pbd/math/vec.h"

namespace meniscus::cloth {

namespace {

using Triangle = std::array<uint32_t, 3>;

void check(const ClothMesh& mesh, std::span<const Vec3> positions) {
  if (positions.size() == mesh.vertices.size()) return;
  throw Error(ErrorCode::invalid_argument, "tearing got " + std::to_string(positions.size()) +
                                               " positions for a cloth of " +
                                               std::to_string(mesh.vertices.size()) + " vertices");
}

void check_vertex(const ClothMesh& mesh, uint32_t vertex) {
  if (vertex < mesh.vertices.size()) return;
  throw Error(ErrorCode::invalid_argument, "tearing got the vertex " + std::to_string(vertex) +
                                               ", but there are " + std::to_string(mesh.vertices.size()));
}

bool uses(const Triangle& t, uint32_t v) {
  return std::find(t.begin(), t.end(), v) != t.end();
}

// The triangles around a vertex, each with the number of its fan. The triangles of a fan are connected across
// edges that end at the vertex.
class FansAround {
 public:
  /// `sides`: a number for each triangle. Triangles with different numbers are not connected.
  FansAround(const ClothMesh& mesh, uint32_t vertex, std::span<const uint32_t> triangles,
             std::vector<int> sides)
      : mesh_(mesh), vertex_(vertex), triangles_(triangles), sides_(std::move(sides)) {
    fan_.assign(triangles.size(), none);
    for (uint32_t k = 0; k < triangles.size(); ++k) {
      if (fan_[k] == none) fill(k, count_++);
    }
  }

  uint32_t count() const { return count_; }
  uint32_t of(size_t k) const { return fan_[k]; }

  /// Neighbours at edges across which the sides differ.
  std::vector<uint32_t> parted_neighbours() const {
    std::map<uint32_t, int> side_at;
    std::set<uint32_t> parted;
    for (size_t k = 0; k < triangles_.size(); ++k) {
      for (uint32_t w : mesh_.triangles[triangles_[k]]) {
        if (w == vertex_) continue;
        if (side_at.try_emplace(w, sides_[k]).first->second != sides_[k]) parted.insert(w);
      }
    }
    return {parted.begin(), parted.end()};
  }

 private:
  void fill(uint32_t seed, uint32_t fan) {
    fan_[seed] = fan;
    std::vector<uint32_t> front{seed};
    while (!front.empty()) {
      const uint32_t k = front.back();
      front.pop_back();
      for (uint32_t other = 0; other < fan_.size(); ++other) {
        if (fan_[other] != none || sides_[other] != sides_[k] || !share_edge(k, other)) continue;
        fan_[other] = fan;
        front.push_back(other);
      }
    }
  }

  bool share_edge(uint32_t k, uint32_t other) const {
    const Triangle &t = mesh_.triangles[triangles_[k]], &u = mesh_.triangles[triangles_[other]];
    return std::any_of(t.begin(), t.end(), [&](uint32_t w) { return w != vertex_ && uses(u, w); });
  }

  const ClothMesh& mesh_;
  uint32_t vertex_;
  std::span<const uint32_t> triangles_;
  std::vector<int> sides_;
  std::vector<uint32_t> fan_;
  uint32_t count_ = 0;
};

class Tearing {
 public:
  Tearing(ClothMesh& mesh, std::span<const Vec3> positions)
      : mesh_(mesh), positions_(positions), around_(mesh), waits_(mesh.vertices.size()) {}

  /// Splits `vertex` along a plane. Returns whether anything parted.
  bool split(uint32_t vertex, Vec3 normal) {
    const auto triangles = around_.of(vertex);
    const FansAround fans(mesh_, vertex, triangles, sides(vertex, normal));
    if (fans.count() < 2) return false;
    const std::vector<uint32_t> neighbours = fans.parted_neighbours();
    part(vertex, fans);
    for (uint32_t w : neighbours) {
      const FansAround of_neighbour(mesh_, w, around_.of(w), std::vector<int>(around_.of(w).size(), 0));
      part(w, of_neighbour);
    }
    return true;
  }

  /// Whether the vertex shares a triangle with a vertex that was split.
  bool waits(uint32_t vertex) const { return waits_[vertex]; }

  std::vector<TornVertex> torn() && { return std::move(torn_); }

 private:
  std::vector<int> sides(uint32_t vertex, Vec3 normal) const {
    std::vector<int> result;
    for (uint32_t t : around_.of(vertex)) {
      const auto& [a, b, c] = mesh_.triangles[t];
      const Vec3 x = positions_[vertex];
      const Vec3 displacement = (positions_[a] - x) + (positions_[b] - x) + (positions_[c] - x);
      result.push_back(dot(normal, displacement) > 0);
    }
    return result;
  }

  /// The first fan keeps the vertex, and each other fan gets a copy.
  void part(uint32_t vertex, const FansAround& fans) {
    if (fans.count() < 2) return;
    const auto triangles = around_.of(vertex);
    for (uint32_t t : triangles) {
      for (uint32_t v : mesh_.triangles[t]) {
        if (v < waits_.size()) waits_[v] = true;
      }
    }
    const auto first_copy = static_cast<uint32_t>(mesh_.vertices.size());
    for (uint32_t fan = 1; fan < fans.count(); ++fan) add_copy(vertex);
    for (size_t k = 0; k < triangles.size(); ++k) {
      if (fans.of(k) == 0) continue;
      Triangle& t = mesh_.triangles[triangles[k]];
      std::replace(t.begin(), t.end(), vertex, first_copy + fans.of(k) - 1);
    }
  }

  void add_copy(uint32_t vertex) {
    torn_.push_back({static_cast<uint32_t>(mesh_.vertices.size()), vertex});
    mesh_.vertices.push_back(Vec3(mesh_.vertices[vertex]));
    if (!mesh_.material.empty()) mesh_.material.push_back(std::array(mesh_.material[vertex]));
  }

  ClothMesh& mesh_;
  std::span<const Vec3> positions_;
  VertexTriangles around_;  // of the original mesh; valid for vertices that do not wait
  std::vector<bool> waits_;
  std::vector<TornVertex> torn_;
};

// Sorts edges by stretch, the most stretched first.
std::vector<OverstretchedEdge> by_stretch(std::span<const OverstretchedEdge> edges) {
  std::vector<OverstretchedEdge> sorted(edges.begin(), edges.end());
  std::sort(sorted.begin(), sorted.end(), [](const OverstretchedEdge& e, const OverstretchedEdge& f) {
    return std::tie(f.stretch, e.a, e.b) < std::tie(e.stretch, f.a, f.b);
  });
  return sorted;
}

std::map<uint32_t, float> stretch_at_vertices(const std::vector<OverstretchedEdge>& edges) {
  std::map<uint32_t, float> stretch;
  for (const OverstretchedEdge& e : edges) {
    stretch[e.a] += e.stretch;
    stretch[e.b] += e.stretch;
  }
  return stretch;
}

}  // namespace

std::vector<TornVertex> tear(ClothMesh& mesh, uint32_t vertex, std::span<const Vec3> positions, Vec3 normal) {
  check(mesh, positions);
  check_vertex(mesh, vertex);
  Tearing tearing(mesh, positions);
  tearing.split(vertex, normal);
  return std::move(tearing).torn();
}

std::vector<TornVertex> tear_along(ClothMesh& mesh, std::span<const Vec3> positions,
                                   std::span<const OverstretchedEdge> edges, uint32_t most_splits) {
  check(mesh, positions);
  for (const OverstretchedEdge& e : edges) {
    check_vertex(mesh, e.a);
    check_vertex(mesh, e.b);
  }
  const std::vector<OverstretchedEdge> worst_first = by_stretch(edges);
  const std::map<uint32_t, float> stretch = stretch_at_vertices(worst_first);
  Tearing tearing(mesh, positions);
  uint32_t splits = 0;
  for (const OverstretchedEdge& e : worst_first) {
    if (splits == most_splits) break;
    const bool b_first = stretch.at(e.b) > stretch.at(e.a);
    for (uint32_t v : {b_first ? e.b : e.a, b_first ? e.a : e.b}) {
      if (tearing.waits(v) || !tearing.split(v, positions[e.b] - positions[e.a])) continue;
      ++splits;
      break;
    }
  }
  return std::move(tearing).torn();
}

}  // namespace meniscus::cloth
