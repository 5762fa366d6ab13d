// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Measures cloth, and finds its borders.
#include "sdk/render/meshes/cloth_detail.h"

#include <algorithm>
#include <cmath>

#include "pbd/math/vec.h"

namespace meniscus::render {
namespace {

constexpr float threads_a_side = 100;

/// Sums over the triangles of a piece.
struct PieceSums {
  double area = 0;                  // m²
  double along_u = 0, along_v = 0;  // m³, metres for each unit of the texture times the area
  double edges = 0;                 // m
  std::size_t edge_count = 0;
};

void add_texture_scale(PieceSums& sums, Vec3 a, Vec3 b, float area, std::span<const TexturePoint> at) {
  const float u1 = at[1].u - at[0].u, v1 = at[1].v - at[0].v, u2 = at[2].u - at[0].u, v2 = at[2].v - at[0].v;
  const float determinant = u1 * v2 - u2 * v1;
  if (std::abs(determinant) < 1e-12f) return;
  sums.along_u += double{area * length((v2 / determinant) * a - (v1 / determinant) * b)};
  sums.along_v += double{area * length((u1 / determinant) * b - (u2 / determinant) * a)};
}

std::vector<PieceSums> sums_of(const io::ClothFrame& frame) {
  std::vector<PieceSums> all(piece_count(frame));
  for (std::size_t t = 0; t < frame.triangles.size(); ++t) {
    const auto& corners = frame.triangles[t];
    const Vec3 from = frame.vertices[corners[0]], a = frame.vertices[corners[1]] - from,
               b = frame.vertices[corners[2]] - from;
    const float area = 0.5f * length(cross(a, b));
    if (!std::isfinite(area)) continue;
    PieceSums& sums = all[frame.pieces[t]];
    sums.area += double{area};
    sums.edges += double{length(a)} + double{length(b)} + double{length(b - a)};
    sums.edge_count += 3;
    if (!frame.texture.empty())
      add_texture_scale(sums, a, b, area, std::span(frame.texture).subspan(3 * t, 3));
  }
  return all;
}

}  // namespace

std::size_t piece_count(const io::ClothFrame& frame) {
  const auto last = std::max_element(frame.pieces.begin(), frame.pieces.end());
  return last == frame.pieces.end() ? 0 : std::size_t{*last} + 1;
}

std::vector<ClothDetail> cloth_details(const io::ClothFrame& frame) {
  std::vector<ClothDetail> details;
  for (const PieceSums& sums : sums_of(frame)) {
    ClothDetail& detail = details.emplace_back();
    if (sums.area <= 0) continue;
    const double thread = std::sqrt(sums.area) / double{threads_a_side};
    detail.threads = {static_cast<float>(std::round(sums.along_u / sums.area / thread)),
                      static_cast<float>(std::round(sums.along_v / sums.area / thread))};
    // Half of the thickness that FabricDef has by default; less for coarse meshes.
    detail.hem =
        static_cast<float>(std::min(sums.edges / static_cast<double>(8 * sums.edge_count), 0.4 * thread));
  }
  return details;
}

std::vector<BorderEdge> border_edges(std::span<const std::array<uint32_t, 3>> triangles) {
  struct Edge {
    uint32_t low, high;
    BorderEdge edge;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const uint32_t from = triangles[t][k], to = triangles[t][(k + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), {from, to, t}});
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  const auto same = [](const Edge& a, const Edge& b) { return a.low == b.low && a.high == b.high; };
  std::vector<BorderEdge> borders;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_shared =
        (i > 0 && same(edges[i - 1], edges[i])) || (i + 1 < edges.size() && same(edges[i], edges[i + 1]));
    if (!is_shared) borders.push_back(edges[i].edge);
  }
  std::stable_sort(borders.begin(), borders.end(),
                   [](const BorderEdge& a, const BorderEdge& b) { return a.triangle < b.triangle; });
  return borders;
}

}  // namespace meniscus::render
