// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Takes up, moves and drips the fluid that cloth holds.
#include "sdk/world/cloth/cloth_water.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "pbd/mesh_edges.h"
#include "sdk/world/cloth/tuning.h"

namespace meniscus {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double area_of(Vec3 a, Vec3 b, Vec3 c) {
  return 0.5 * double{length(cross(b - a, c - a))};
}

/// By vertex: the ratio of its area to that at rest, or the inverse, whichever is less than 1.
std::vector<double> open_pores(const cloth::ClothMesh& mesh, std::span<const Vec3> now) {
  std::vector<double> rest(now.size()), area(now.size());
  for (const auto& t : mesh.triangles) {
    const double before = area_of(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    const double after = area_of(now[t[0]], now[t[1]], now[t[2]]);
    for (const uint32_t v : t) {
      rest[v] += before;
      area[v] += after;
    }
  }
  for (size_t v = 0; v < rest.size(); ++v) rest[v] = std::min(area[v] / rest[v], rest[v] / area[v]);
  return rest;
}

}  // namespace

VertexGraph make_graph(const cloth::ClothMesh& mesh) {
  VertexGraph graph;
  graph.start.resize(mesh.vertices.size() + 1);
  const std::vector<pbd::EdgeUse> uses = pbd::edge_uses(mesh);
  const auto for_each = [&](const auto& visit) {
    pbd::for_each_edge(uses, [&](std::span<const pbd::EdgeUse> edge) {
      visit(edge[0].low, edge[0].high);
      visit(edge[0].high, edge[0].low);
    });
  };
  for_each([&](uint32_t a, uint32_t) { ++graph.start[a + 1]; });
  for (size_t v = 0; v + 1 < graph.start.size(); ++v) graph.start[v + 1] += graph.start[v];
  graph.edges.resize(graph.start.back());
  std::vector<uint32_t> next = graph.start;
  for_each([&](uint32_t a, uint32_t b) {
    graph.edges[next[a]++] = {b, length(mesh.vertices[b] - mesh.vertices[a])};
  });
  return graph;
}

ClothWater::ClothWater(ClothEntry& entry, double particle_mass, std::vector<bool> held)
    : entry_(entry),
      particle_(particle_mass),
      dry_(entry.constraints.masses),
      water_(entry.water),
      held_(std::move(held)),
      open_(open_pores(entry.mesh, entry.range.state.positions)),
      momentum_(dry_.size()),
      way_(dry_.size(), infinite) {
  reach_ = cloth_world_tuning::wetting_reach *
               std::sqrt(particle_ / (M_PI * double{entry.def.fabric.absorbency})) +
           double{mean_edge(entry.mesh)};
  for (uint32_t v = 0; v < dry_.size(); ++v) {
    const Vec3 u = entry.range.state.velocities[v];
    if (!held_[v]) momentum_[v].add(mass(v), {double{u.x}, double{u.y}, double{u.z}});
  }
}

double ClothWater::capacity(uint32_t v) const {
  const FabricDef& f = entry_.def.fabric;
  return double{dry_[v]} / double{f.density} * double{f.absorbency};
}

double ClothWater::kept(uint32_t v) const {
  return double{entry_.def.fabric.retention} * open_[v] * capacity(v);
}

MomentumSum ClothWater::velocity(uint32_t v) const {
  MomentumSum u;
  u.add(1 / mass(v), momentum_[v]);
  return u;
}

/// The nearest vertices along the cloth whose available amounts add up to a particle. Empty if there are not
/// enough.
template <class Available>
std::vector<ClothWater::Part> ClothWater::gather(uint32_t vertex, const Available& available) {
  using Stop = std::pair<double, uint32_t>;
  std::priority_queue<Stop, std::vector<Stop>, std::greater<>> next;
  std::vector<uint32_t> seen{vertex};
  std::vector<Part> parts;
  double missing = particle_;
  way_[vertex] = 0;
  next.push({0, vertex});
  while (!next.empty() && missing > 0) {
    const auto [way, v] = next.top();
    next.pop();
    if (way > way_[v]) continue;
    if (const double part = std::min(missing, available(v)); part > 0) {
      parts.push_back({v, part});
      missing -= part;
    }
    for (const VertexGraph::Edge& e : entry_.graph.of(v)) {
      const double further = way + double{e.length};
      if (further > reach_ || further >= way_[e.to]) continue;
      way_[e.to] = further;
      seen.push_back(e.to);
      next.push({further, e.to});
    }
  }
  for (const uint32_t v : seen) way_[v] = infinite;
  if (missing > 0) parts.clear();
  return parts;
}

bool ClothWater::take(uint32_t vertex, Vec3 velocity) {
  const std::vector<Part> parts =
      gather(vertex, [&](uint32_t v) { return std::max(0.0, capacity(v) - water_[v]); });
  for (const Part& part : parts)
    add(part.vertex, part.mass, {double{velocity.x}, double{velocity.y}, double{velocity.z}});
  return !parts.empty();
}

void ClothWater::add(uint32_t v, double amount, const MomentumSum& velocity) {
  if (!held_[v]) momentum_[v].add(amount, velocity);
  water_[v] += amount;
  changed_ = true;
}

void ClothWater::move(uint32_t from, uint32_t to, double amount) {
  const MomentumSum u = velocity(from);
  add(from, -amount, u);
  add(to, amount, u);
}

void ClothWater::run_down(Vec3 down, double dt) {
  const std::vector<Vec3>& x = entry_.range.state.positions;
  std::vector<double> flowing(water_.size());
  for (uint32_t v = 0; v < water_.size(); ++v) flowing[v] = surplus(v);
  for (uint32_t v = 0; v < water_.size(); ++v) {
    if (flowing[v] == 0) continue;
    const auto slope = [&](const VertexGraph::Edge& e) {
      const Vec3 way = x[e.to] - x[v];
      return std::max(0.0, double{dot(way, down)} / std::max(1e-9, double{length(way)}));
    };
    double all = 0, steepest = 0, edge = 0;
    for (const VertexGraph::Edge& e : entry_.graph.of(v)) {
      all += slope(e);
      if (slope(e) <= steepest) continue;
      steepest = slope(e);
      edge = double{e.length};
    }
    if (all == 0) continue;
    const double fraction = std::min(1.0, double{entry_.def.fabric.drainage} * dt * steepest / edge);
    for (const VertexGraph::Edge& e : entry_.graph.of(v)) {
      const double part = flowing[v] * fraction * slope(e) / all;
      if (part > 0) move(v, e.to, part);
    }
  }
}

std::vector<uint32_t> ClothWater::dripping(Vec3 down) {
  const std::vector<Vec3>& x = entry_.range.state.positions;
  std::vector<uint32_t> lowest;
  for (uint32_t v = 0; v < water_.size(); ++v) {
    if (surplus(v) == 0) continue;
    const auto edges = entry_.graph.of(v);
    if (std::all_of(edges.begin(), edges.end(),
                    [&](const VertexGraph::Edge& e) {
                      return dot(x[e.to] - x[v], down) <= cloth_world_tuning::level * e.length;
                    }) &&
        !gather(v, [&](uint32_t u) { return surplus(u); }).empty())
      lowest.push_back(v);
  }
  std::stable_sort(lowest.begin(), lowest.end(),
                   [&](uint32_t a, uint32_t b) { return dot(x[a], down) > dot(x[b], down); });
  return lowest;
}

std::optional<Vec3> ClothWater::drip(uint32_t vertex) {
  const std::vector<Part> parts = gather(vertex, [&](uint32_t v) { return surplus(v); });
  if (parts.empty()) return {};
  MomentumSum drop;
  for (const Part& part : parts) {
    const MomentumSum u = velocity(part.vertex);
    add(part.vertex, -part.mass, u);
    drop.add(part.mass / particle_, u);
  }
  return Vec3{static_cast<float>(drop.x), static_cast<float>(drop.y), static_cast<float>(drop.z)};
}

bool ClothWater::finish() {
  if (!changed_) return false;
  VertexRange& range = entry_.range;
  for (uint32_t v = 0; v < water_.size(); ++v) {
    const MomentumSum u = velocity(v);
    range.masses[v] = static_cast<float>(mass(v));
    range.state.velocities[v] = {static_cast<float>(u.x), static_cast<float>(u.y), static_cast<float>(u.z)};
  }
  entry_.wetness.clear();
  return true;
}

}  // namespace meniscus
