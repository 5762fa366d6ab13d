// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes the coloured triangles of cloth and ropes.
#include <algorithm>
#include <iterator>
#include <utility>

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

/// The triangles of cloth, as they are added.
class ClothSurface {
 public:
  ClothSurface(const io::ClothFrame& frame, const std::vector<Vec3>& colors,
               std::span<const ClothDetail> details, std::span<const Vec3> triangle_colors)
      : frame_(frame), colors_(colors), details_(details), triangle_colors_(triangle_colors) {}

  void add_triangle(std::size_t i) {
    if (!is_shown(i)) return;
    const ClothDetail& detail = details_[frame_.pieces[i]];
    for (std::size_t k = 0; k < 3; ++k) {
      const uint32_t v = frame_.triangles[i][k];
      Vertex& vertex = all_.emplace_back(Vertex{frame_.vertices[v], frame_.normals[v], color(i, v)});
      if (frame_.texture.empty() || !triangle_colors_.empty()) continue;
      const TexturePoint at = frame_.texture[3 * i + k];
      vertex.place = {at.u * detail.threads[0], at.v * detail.threads[1]};
    }
  }

  void add_hems(std::span<const BorderEdge> borders) {
    // Outwards at each vertex, so that neighbouring tubes meet.
    std::vector<Vec3> outwards(frame_.vertices.size());
    for (const BorderEdge& edge : borders) {
      if (!is_shown(edge.triangle)) continue;
      const Vec3 along = normalized_or(frame_.vertices[edge.to] - frame_.vertices[edge.from], {});
      for (const uint32_t v : {edge.from, edge.to})
        outwards[v] = outwards[v] + cross(along, frame_.normals[v]);
    }
    for (const BorderEdge& edge : borders) {
      if (is_shown(edge.triangle)) add_hem(edge, outwards);
    }
  }

  Triangles take() { return std::move(all_); }

 private:
  bool is_shown(std::size_t triangle) const {
    const auto& t = frame_.triangles[triangle];
    return std::all_of(t.begin(), t.end(), [&](uint32_t v) { return is_finite(frame_.vertices[v]); });
  }

  Float4 color(std::size_t triangle, uint32_t v) const {
    const Float4 plain = paint(colors_, frame_.pieces[triangle], ClothDef{}.color, Look::cloth);
    if (!triangle_colors_.empty()) return float4(triangle_colors_[triangle], plain[3]);
    return wetted(plain, frame_.wetness.empty() ? 0 : frame_.wetness[v]);
  }

  /// A rolled hem in section: it begins and ends on the sheet, and is round outwards.
  struct HemPoint {
    float up, out;  // from the border, in radii
    float normal_up, normal_out;
  };
  static constexpr float slant = 0.70710678f;
  static constexpr HemPoint hem_section[] = {{0, -3, 1, 0},
                                             {1, 0, 1, 0},
                                             {slant, slant, slant, slant},
                                             {0, 1, 0, 1},
                                             {-slant, slant, -slant, slant},
                                             {-1, 0, -1, 0},
                                             {0, -3, -1, 0}};

  void add_hem(const BorderEdge& edge, const std::vector<Vec3>& outwards) {
    const float radius = details_[frame_.pieces[edge.triangle]].hem;
    const auto corner = [&](uint32_t v, const HemPoint& p) {
      const Vec3 up = frame_.normals[v], out = normalized_or(outwards[v], up);
      return Vertex{frame_.vertices[v] + radius * (p.up * up + p.out * out),
                    p.normal_up * up + p.normal_out * out,
                    color(edge.triangle, v),
                    {}};
    };
    for (std::size_t k = 0; k + 1 < std::size(hem_section); ++k) {
      const Vertex a = corner(edge.from, hem_section[k]), b = corner(edge.from, hem_section[k + 1]);
      const Vertex c = corner(edge.to, hem_section[k]), d = corner(edge.to, hem_section[k + 1]);
      all_.insert(all_.end(), {a, b, c, b, d, c});
    }
  }

  const io::ClothFrame& frame_;
  const std::vector<Vec3>& colors_;
  std::span<const ClothDetail> details_;
  std::span<const Vec3> triangle_colors_;
  Triangles all_;
};

}  // namespace

Triangles cloth_surface(const io::ClothFrame& frame, const std::vector<Vec3>& colors,
                        std::span<const ClothDetail> details, std::span<const BorderEdge> borders,
                        std::span<const Vec3> triangle_colors) {
  ClothSurface surface(frame, colors, details, triangle_colors);
  for (std::size_t i = 0; i < frame.triangles.size(); ++i) surface.add_triangle(i);
  surface.add_hems(borders);
  return surface.take();
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
