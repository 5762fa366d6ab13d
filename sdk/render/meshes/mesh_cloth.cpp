// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes the coloured triangles of cloth and ropes.
#include <algorithm>

#include "sdk/render/meshes/mesh.h"
#include "sdk/render/meshes/tube.h"

namespace meniscus::render {
namespace {

Float4 paint(const std::vector<Vec3>& colors, std::size_t i, Vec3 otherwise, Look look) {
  return float4(i < colors.size() ? colors[i] : otherwise, static_cast<float>(look));
}

/// Water between the fibres takes away half of the light that dry cloth reflects.
Float4 wetted(Float4 color, float wetness) {
  const float light = 1 - 0.5f * std::min(wetness, 1.0f);
  for (int k = 0; k < 3; ++k) color[k] *= light;
  return color;
}

}  // namespace

Triangles cloth_surface(const io::ClothFrame& frame, const std::vector<Vec3>& colors,
                        std::span<const Vec3> triangle_colors) {
  Triangles all;
  const auto is_shown = [&](uint32_t v) { return is_finite(frame.vertices[v]); };
  for (std::size_t i = 0; i < frame.triangles.size(); ++i) {
    const auto& t = frame.triangles[i];
    if (!std::all_of(t.begin(), t.end(), is_shown)) continue;
    Float4 color = paint(colors, frame.pieces[i], ClothDef{}.color, Look::cloth);
    if (!triangle_colors.empty()) color = float4(triangle_colors[i], color[3]);
    for (const uint32_t v : t) {
      const float wetness = frame.wetness.empty() || !triangle_colors.empty() ? 0 : frame.wetness[v];
      all.push_back({frame.vertices[v], frame.normals[v], wetted(color, wetness), {}});
    }
  }
  return all;
}

Triangles rope_surface(const io::RopeFrame& frame, const std::vector<Vec3>& colors) {
  Triangles all;
  for (std::size_t i = 0; i < frame.lines.size(); ++i) {
    std::vector<Vec3> line;
    for (const uint32_t v : frame.lines[i]) line.push_back(frame.vertices[v]);
    if (!std::all_of(line.begin(), line.end(), [](Vec3 p) { return is_finite(p); })) continue;
    add_tube(all, line, frame.radii[i], paint(colors, i, RopeDef{}.color, Look::rope));
  }
  return all;
}

}  // namespace meniscus::render
