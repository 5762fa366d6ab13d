// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds the table of triangles of the 256 cases of marching cubes.
#include "pbd/marching_cubes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace meniscus::pbd {
namespace {

using Loop = std::vector<uint8_t>;  // edges of the cube, in order around a piece of the surface

constexpr uint8_t no_edge = 0xff;

uint8_t edge_between(uint32_t a, uint32_t b) {
  for (uint8_t e = 0; e < 12; ++e) {
    const auto [corner, axis] = cube_edge(e);
    if (std::min(a, b) == corner && std::max(a, b) == (corner | 1u << axis)) return e;
  }
  return no_edge;
}

/// Corners of face 2 axis + side, counter-clockwise as seen from outside.
std::array<uint32_t, 4> face_corners(uint32_t face) {
  const uint32_t axis = face / 2, base = (face & 1) << axis;
  const uint32_t u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3;
  if (face & 1) return {base, base | u, base | u | v, base | v};
  return {base, base | v, base | u | v, base | u};
}

bool on_face(uint8_t edge, uint32_t face) {
  const auto [corner, axis] = cube_edge(edge);
  return axis != face / 2 && (corner >> face / 2 & 1) == (face & 1);
}

bool share_a_face(uint8_t a, uint8_t b) {
  for (uint32_t face = 0; face < 6; ++face) {
    if (on_face(a, face) && on_face(b, face)) return true;
  }
  return false;
}

/// For each edge that the surface cuts, the next one around. Segments run along the faces, with the inside on
/// their right as seen from outside.
std::array<uint8_t, 12> next_edges(uint32_t inside) {
  std::array<uint8_t, 12> next;
  next.fill(no_edge);
  for (uint32_t face = 0; face < 6; ++face) {
    const auto corners = face_corners(face);
    const auto is_in = [&](int k) { return (inside >> corners[k & 3] & 1) != 0; };
    for (int k = 0; k < 4; ++k) {
      if (!is_in(k) || is_in(k + 1)) continue;
      int entry = k;  // back along the inside corners
      while (is_in(entry - 1)) --entry;
      next[edge_between(corners[k], corners[(k + 1) & 3])] =
          edge_between(corners[(entry - 1) & 3], corners[entry & 3]);
    }
  }
  return next;
}

std::vector<Loop> loops_of(uint32_t inside) {
  std::array<uint8_t, 12> next = next_edges(inside);
  std::vector<Loop> loops;
  for (uint8_t first = 0; first < 12; ++first) {
    Loop loop;
    for (uint8_t e = first; next[e] != no_edge;) {
      loop.push_back(e);
      e = std::exchange(next[e], no_edge);
    }
    if (!loop.empty()) loops.push_back(loop);
  }
  return loops;
}

/// Divides loop[from … to] into triangles whose inner edges do not lie in a face. False where this is
/// impossible.
bool divide(const Loop& loop, size_t from, size_t to, std::vector<std::array<uint8_t, 3>>& triangles) {
  if (to - from < 2) return true;
  const auto may_join = [&](size_t a, size_t b) { return b - a == 1 || !share_a_face(loop[a], loop[b]); };
  for (size_t k = from + 1; k < to; ++k) {
    if (!may_join(from, k) || !may_join(k, to)) continue;
    const size_t before = triangles.size();
    triangles.push_back({loop[from], loop[to], loop[k]});
    if (divide(loop, from, k, triangles) && divide(loop, k, to, triangles)) return true;
    triangles.resize(before);
  }
  return false;
}

}  // namespace

std::vector<CubeTriangles> marching_cubes() {
  std::vector<CubeTriangles> table;
  for (uint32_t inside = 0; inside < 256; ++inside) {
    std::vector<std::array<uint8_t, 3>> triangles;
    for (const Loop& loop : loops_of(inside)) {
      [[maybe_unused]] const bool done = divide(loop, 0, loop.size() - 1, triangles);
      assert(done);
    }
    CubeTriangles cube{{}, static_cast<uint8_t>(triangles.size())};
    uint8_t* to = cube.edges;
    for (const auto& triangle : triangles) to = std::copy(triangle.begin(), triangle.end(), to);
    table.push_back(cube);
  }
  return table;
}

}  // namespace meniscus::pbd
