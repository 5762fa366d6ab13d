// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the parts of frames with several meshes.
#include "sdk/io/mesh_parts.h"

#include <algorithm>

namespace meniscus::io {
namespace {

/// The parts by their numbers of triangles; `count_vertices(part)` gives those of a part's vertices.
template <class CountVertices>
std::vector<MeshPart> parts_with(std::size_t count, const std::vector<uint32_t>& part_of_triangle,
                                 const CountVertices& count_vertices) {
  std::vector<MeshPart> parts(count);
  for (const uint32_t part : part_of_triangle) ++parts.at(part).triangle_count;
  std::size_t triangle = 0;
  uint32_t vertex = 0;
  for (std::size_t i = 0; i < count; ++i) {
    MeshPart& part = parts[i];
    part.first_vertex = vertex;
    part.first_triangle = triangle;
    part.vertex_count = count_vertices(i, part);
    vertex += part.vertex_count;
    triangle += part.triangle_count;
  }
  return parts;
}

}  // namespace

std::vector<MeshPart> parts_of(const ClothFrame& frame) {
  const std::vector<std::size_t> counts = frame.vertex_counts();
  return parts_with(frame.names.size(), frame.pieces,
                    [&](std::size_t i, const MeshPart&) { return static_cast<uint32_t>(counts[i]); });
}

std::vector<MeshPart> parts_of(const LiquidFrame& frame) {
  return parts_with(frame.names.size(), frame.fluids, [&](std::size_t, const MeshPart& part) {
    uint32_t end = part.first_vertex;
    for (const auto& t : part.triangles(frame.triangles)) end = std::max({end, t[0] + 1, t[1] + 1, t[2] + 1});
    return end - part.first_vertex;
  });
}

}  // namespace meniscus::io
