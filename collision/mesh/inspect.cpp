// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reports on mesh files.
#include "collision/mesh/inspect.h"

#include <numeric>

#include "collision/mesh/clean.h"
#include "collision/mesh/defects.h"
#include "pbd/mesh_edges.h"

namespace meniscus::collision {

namespace {

/// Groups of vertices that open edges connect.
std::size_t count_holes(const TriangleMesh& mesh) {
  std::vector<uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::size_t holes = 0;
  std::vector<bool> is_seen(mesh.vertices.size());
  pbd::for_each_edge(pbd::edge_uses(mesh), [&](std::span<const pbd::EdgeUse> edge) {
    if (edge.size() != 1) return;
    for (const uint32_t v : {edge[0].low, edge[0].high}) {
      if (!is_seen[v]) ++holes;
      is_seen[v] = true;
    }
    const uint32_t a = root(edge[0].low), b = root(edge[0].high);
    if (a != b) --holes;
    parent[a] = b;
  });
  return holes;
}

}  // namespace

MeshReport inspect_mesh(const std::string& path, float scale) {
  const CleanedMesh clean = load_cleaned_mesh(MeshSource(path, scale));
  const MeshDefects defects = find_defects(clean.mesh);
  MeshReport report;
  report.box = bounds(clean.mesh);
  report.triangles = clean.mesh.triangles.size();
  report.welded = clean.welded;
  report.dropped = clean.dropped;
  report.holes = count_holes(clean.mesh);
  report.open_edges = defects.open_edges.size();
  report.odd_edges = defects.non_manifold_edges.size();
  report.crossings = defects.self_intersections.size();
  report.volume = signed_volume(clean.mesh);
  return report;
}

const char* unit_guess(float longest_side) {
  struct Unit {
    const char* name;
    float metres;
  };
  for (const Unit unit : {Unit{"metres", 1}, Unit{"centimetres", 0.01f}, Unit{"millimetres", 0.001f}}) {
    const float size = longest_side * unit.metres;
    if (size >= 0.02f && size <= 20) return unit.name;
  }
  return "unknown";
}

}  // namespace meniscus::collision
