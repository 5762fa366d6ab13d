// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the texture coordinates of cloth from its rest shape, or reads them from its file.
#include "sdk/world/cloth/cloth_texture.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cloth/build/weld.h"
#include "collision/mesh/mesh.h"
#include "pbd/math/vec.h"

namespace meniscus {
namespace {

using Corners = std::array<TexturePoint, 3>;

/// Once around the y axis is 0 to 1.
float around(Vec3 p) {
  const float turn = std::atan2(p.z, p.x) / (2 * std::numbers::pi_v<float>);
  return turn < 0 ? turn + 1 : turn;
}

/// Corners of a triangle over the seam, where u goes from 1 to 0, lie beyond 1.
void join_at_seam(Corners& corners) {
  float most = 0;
  for (const TexturePoint& c : corners) most = std::max(most, c.u);
  for (TexturePoint& c : corners) c.u += most - c.u > 0.5f ? 1.0f : 0.0f;
}

bool is_on_axis(Vec3 p, float radius) {
  return std::hypot(p.x, p.z) < 1e-5f * radius;
}

Corners tube_corners(const ClothTube& tube, const std::array<Vec3, 3>& at) {
  const float low = -0.5f * tube.height;
  const bool is_bottom = std::all_of(at.begin(), at.end(), [&](Vec3 p) { return p.y == low; });
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_bottom)
      corners[k] = {0.5f + 0.5f * at[k].x / tube.bottom_radius, 0.5f + 0.5f * at[k].z / tube.bottom_radius};
    else
      corners[k] = {around(at[k]), (at[k].y - low) / tube.height};
  }
  if (!is_bottom) join_at_seam(corners);
  return corners;
}

Corners sphere_corners(const ClothSphere& sphere, const std::array<Vec3, 3>& at) {
  Corners corners;
  std::size_t pole = 3;
  for (std::size_t k = 0; k < 3; ++k) {
    const float sine = pbd::clamp(at[k].y / sphere.radius, -1, 1);
    corners[k] = {around(at[k]), 0.5f + std::asin(sine) / std::numbers::pi_v<float>};
    if (is_on_axis(at[k], sphere.radius)) pole = k;
  }
  if (pole < 3) corners[pole].u = corners[(pole + 1) % 3].u;  // a pole has no longitude of its own
  join_at_seam(corners);
  if (pole < 3) corners[pole].u = 0.5f * (corners[(pole + 1) % 3].u + corners[(pole + 2) % 3].u);
  return corners;
}

/// The corner of a triangle of the file at a place; 3 if there is none.
std::size_t corner_at(const TexturedCloth& file, std::size_t triangle, Vec3 place) {
  if (triangle >= file.texture.size()) return 3;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 p = file.mesh.vertices[file.mesh.triangles[triangle][k]];
    if (p.x == place.x && p.y == place.y && p.z == place.z) return k;
  }
  return 3;
}

class MakeTexture {
 public:
  MakeTexture(const ClothEntry& cloth, const FileReader& files) : mesh_(cloth.mesh), files_(files) {}

  std::vector<TexturePoint> operator()(const SheetGeometry& g) const {
    return by_triangle([&](const std::array<Vec3, 3>& at) {
      Corners corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = {0.5f + at[k].x / g.width, 0.5f + at[k].z / g.depth};
      return corners;
    });
  }
  std::vector<TexturePoint> operator()(const ClothTube& g) const {
    return by_triangle([&](const std::array<Vec3, 3>& at) { return tube_corners(g, at); });
  }
  std::vector<TexturePoint> operator()(const ClothSphere& g) const {
    return by_triangle([&](const std::array<Vec3, 3>& at) { return sphere_corners(g, at); });
  }
  std::vector<TexturePoint> operator()(const ClothTriangles&) const { return {}; }
  std::vector<TexturePoint> operator()(const DrivenTriangles&) const { return {}; }
  std::vector<TexturePoint> operator()(const DrivenFiles&) const { return {}; }
  std::vector<TexturePoint> operator()(const ClothFile& g) const {
    return texture_on(mesh_, read_cloth(g, files_));
  }

 private:
  template <class Make>
  std::vector<TexturePoint> by_triangle(const Make& make) const {
    std::vector<TexturePoint> points;
    for (const auto& t : mesh_.triangles) {
      const Corners corners = make({mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]});
      points.insert(points.end(), corners.begin(), corners.end());
    }
    return points;
  }

  const cloth::ClothMesh& mesh_;
  const FileReader& files_;
};

}  // namespace

TexturedCloth read_cloth(const ClothFile& file, const FileReader& files) {
  collision::PaintedMesh painted = collision::load_painted_mesh(collision::MeshSource::of(file, files));
  TexturedCloth result{
      file.file, {std::move(painted.mesh.vertices), std::move(painted.mesh.triangles), {}}, {}};
  if (result.mesh.triangles.empty()) return result;
  std::vector<uint32_t> dropped;
  result.welded = cloth::weld(result.mesh, double{file.weld} * mean_edge(result.mesh), &dropped);
  auto next = dropped.begin();
  for (uint32_t t = 0; t < painted.texture.size(); ++t) {
    if (next != dropped.end() && *next == t)
      ++next;
    else
      result.texture.push_back(painted.texture[t]);
  }
  return result;
}

std::vector<TexturePoint> texture_on(const cloth::ClothMesh& cloth, const TexturedCloth& file) {
  std::vector<TexturePoint> points;
  if (file.texture.empty()) return points;
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    for (const uint32_t v : cloth.triangles[t]) {
      const std::size_t corner = corner_at(file, t, cloth.vertices[v]);
      if (corner == 3)
        throw Error(ErrorCode::mesh,
                    "mesh file '" + file.name + "' has changed since the cloth was made of it");
      points.push_back({file.texture[t][corner][0], file.texture[t][corner][1]});
    }
  }
  return points;
}

std::vector<TexturePoint> texture_of(const ClothEntry& cloth, const FileReader& files) {
  return std::visit(MakeTexture(cloth, files), cloth.def.geometry);
}

}  // namespace meniscus
