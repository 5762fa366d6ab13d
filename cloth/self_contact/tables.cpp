// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds the tables of features, neighbours and fineness for self-contact.
#include "cloth/self_contact/tables.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pbd/contacts.h"
#include "pbd/repeated.h"

namespace meniscus::cloth {

namespace {

using pbd::SurfaceTriangle;

struct EdgePlace {
  uint32_t a, b, place, edge;

  auto key() const { return std::pair(a, b); }
};

uint32_t corner(const SurfaceTriangle& t, uint32_t k) {
  return k == 0 ? t.a : k == 1 ? t.b : t.c;
}

bool stands(const SurfaceTriangle& t) {
  return t.a != pbd::no_index;
}

void own_vertices(std::span<const SurfaceTriangle> triangles, SelfContactTables& tables) {
  std::vector<bool> owned(tables.vertex_piece.size());
  for (size_t place = 0; place < triangles.size(); ++place) {
    const SurfaceTriangle& t = triangles[place];
    for (uint32_t k = 0; stands(t) && k < 3; ++k) {
      const uint32_t v = corner(t, k);
      tables.vertex_piece[v] = t.piece;
      if (!owned[v]) tables.features[place] |= static_cast<uint16_t>(owns_vertex << k);
      owned[v] = true;
    }
  }
}

void own_edges(std::span<const SurfaceTriangle> triangles, SelfContactTables& tables) {
  std::vector<EdgePlace> edges;
  for (uint32_t place = 0; place < triangles.size(); ++place) {
    const SurfaceTriangle& t = triangles[place];
    for (uint32_t k = 0; stands(t) && k < 3; ++k) {
      const uint32_t a = corner(t, k), b = corner(t, (k + 1) % 3);
      edges.push_back({std::min(a, b), std::max(a, b), place, k});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const EdgePlace& x, const EdgePlace& y) {
    return x.key() < y.key() || (x.key() == y.key() && x.place < y.place);
  });
  for (size_t e = 0; e < edges.size();) {
    size_t end = e + 1;
    while (end < edges.size() && edges[end].key() == edges[e].key()) ++end;
    uint16_t& features = tables.features[edges[e].place];
    features |= static_cast<uint16_t>(owns_edge << edges[e].edge);
    if (end == e + 1) features |= static_cast<uint16_t>(is_border << edges[e].edge);
    e = end;
  }
}

void find_neighbours(std::span<const SurfaceTriangle> triangles, SelfContactTables& tables) {
  std::vector<std::pair<uint32_t, uint32_t>> uses, pairs;  // (vertex, group); (group, group)
  for (uint32_t place = 0; place < triangles.size(); ++place)
    for (uint32_t k = 0; stands(triangles[place]) && k < 3; ++k)
      uses.push_back({corner(triangles[place], k), place / 8});
  std::sort(uses.begin(), uses.end());
  uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
  for (size_t begin = 0, end; begin < uses.size(); begin = end) {
    for (end = begin; end < uses.size() && uses[end].first == uses[begin].first;) ++end;
    for (size_t a = begin; a < end; ++a)
      for (size_t b = begin; b < end; ++b) pairs.push_back({uses[a].second, uses[b].second});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  const size_t groups = triangles.size() / 8;
  tables.neighbour_start.assign(groups + 1, 0);
  for (const auto& [a, b] : pairs) {
    ++tables.neighbour_start[a + 1];
    tables.neighbours.push_back(b);
  }
  for (size_t g = 0; g < groups; ++g) tables.neighbour_start[g + 1] += tables.neighbour_start[g];
}

void measure_fineness(std::span<const SurfaceTriangle> triangles, std::span<const Vec3> positions,
                      SelfContactTables& tables) {
  for (const SurfaceTriangle& t : triangles) {
    if (!stands(t)) continue;
    const Vec3 ab = positions[t.b] - positions[t.a], ac = positions[t.c] - positions[t.a], bc = ac - ab;
    const float longest = std::sqrt(std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)}));
    float& fineness = tables.fineness[t.piece];
    if (longest > 0) fineness = std::min(fineness, length(cross(ab, ac)) / longest);
  }
}

}  // namespace

SelfContactTables build_tables(std::span<const SurfaceTriangle> triangles, std::span<const Vec3> positions,
                               size_t pieces) {
  SelfContactTables tables;
  tables.features.assign(triangles.size(), 0);
  tables.fineness.assign(pieces, 1e30f);
  tables.vertex_piece.assign(positions.size(), pbd::no_index);
  own_vertices(triangles, tables);
  own_edges(triangles, tables);
  find_neighbours(triangles, tables);
  measure_fineness(triangles, positions, tables);
  return tables;
}

SelfContactTables of_worlds(const SelfContactTables& one, uint32_t pieces, uint32_t worlds) {
  const auto groups = static_cast<uint32_t>(one.neighbour_start.size() - 1),
             neighbours = static_cast<uint32_t>(one.neighbours.size());
  SelfContactTables all;
  all.fineness = one.fineness;
  all.features = pbd::repeated(std::span<const uint16_t>(one.features), worlds);
  all.vertex_piece =
      pbd::repeated(std::span<const uint32_t>(one.vertex_piece), worlds, [&](uint32_t& piece, uint32_t w) {
        if (piece != pbd::no_index) piece += w * pieces;
      });
  all.neighbours = pbd::repeated(std::span<const uint32_t>(one.neighbours), worlds,
                                 [&](uint32_t& group, uint32_t w) { group += w * groups; });
  all.neighbour_start = pbd::repeated(std::span<const uint32_t>(one.neighbour_start).first(groups), worlds,
                                      [&](uint32_t& start, uint32_t w) { start += w * neighbours; });
  all.neighbour_start.push_back(worlds * neighbours);
  return all;
}

}  // namespace meniscus::cloth
