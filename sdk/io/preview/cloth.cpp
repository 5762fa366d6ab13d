// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Turns cloth and ropes into triangles and spheres of the preview.
#include "sdk/io/preview/cloth.h"

#include <algorithm>
#include <numbers>

namespace meniscus::io {
namespace {

constexpr float back_shade = 0.45f;  // of the front's colour
constexpr int around = 12;           // facets of a rope

Vec3 color_of(std::size_t i, std::span<const Vec3> colors, Vec3 otherwise) {
  return i < colors.size() ? colors[i] : otherwise;
}

/// Adds a tube from one vertex to the next, without caps: a ball sits at each vertex.
void add_tube(Drawing& drawing, Vec3 from, Vec3 to, float radius, uint32_t surface) {
  const Vec3 along = normalized_or(to - from, {0, 1, 0});
  const Vec3 helper = std::abs(along.y) < 0.9f ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  const Vec3 across = normalized_or(cross(along, helper), helper), third = cross(along, across);
  const auto spoke = [&](int k) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k % around) / around;
    return std::cos(angle) * across + std::sin(angle) * third;
  };
  for (int k = 0; k < around; ++k) {
    const Vec3 a = spoke(k), b = spoke(k + 1);
    drawing.triangles.push_back(
        {{from + radius * a, from + radius * b, to + radius * a}, {a, b, a}, surface});
    drawing.triangles.push_back({{from + radius * b, to + radius * b, to + radius * a}, {b, b, a}, surface});
  }
}

}  // namespace

void add_cloth(Drawing& drawing, const ClothFrame& frame, std::span<const Vec3> colors) {
  const auto first = static_cast<uint32_t>(drawing.surfaces.size());
  for (std::size_t i = 0; i < frame.names.size(); ++i) {
    const Vec3 color = color_of(i, colors, ClothDef{}.color);
    drawing.add_surface({color, 0});
    drawing.add_surface({back_shade * color, 0});
  }
  const auto is_shown = [&](uint32_t v) { return is_finite(frame.vertices[v]); };
  for (std::size_t i = 0; i < frame.triangles.size(); ++i) {
    const auto& t = frame.triangles[i];
    if (!std::all_of(t.begin(), t.end(), is_shown)) continue;
    const uint32_t front = first + 2 * frame.pieces[i];
    drawing.triangles.push_back({{frame.vertices[t[0]], frame.vertices[t[1]], frame.vertices[t[2]]},
                                 {frame.normals[t[0]], frame.normals[t[1]], frame.normals[t[2]]},
                                 front,
                                 front + 1});
  }
}

void add_ropes(Drawing& drawing, const RopeFrame& frame, std::span<const Vec3> colors) {
  for (std::size_t i = 0; i < frame.lines.size(); ++i) {
    const uint32_t surface = drawing.add_surface({color_of(i, colors, RopeDef{}.color), 0.1f});
    const std::vector<uint32_t>& line = frame.lines[i];
    for (std::size_t k = 0; k < line.size(); ++k) {
      const Vec3 here = frame.vertices[line[k]];
      if (!is_finite(here)) continue;
      drawing.spheres.push_back({here, frame.radii[i], surface});
      if (k == 0 || !is_finite(frame.vertices[line[k - 1]])) continue;
      add_tube(drawing, frame.vertices[line[k - 1]], here, frame.radii[i], surface);
    }
  }
}

}  // namespace meniscus::io
