// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/io/preview/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "collision/mesh.h"

namespace meniscus::io {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr int around = 64;  // facets of what is round

using Corner = std::array<Vec3, 2>;  // position and normal, in the shape's frame

/// The corners of a box: bit 0, 1, 2 of the number say on which side in x, y, z.
Vec3 corner(Vec3 half, int number) {
  return {number & 1 ? half.x : -half.x, number & 2 ? half.y : -half.y, number & 4 ? half.z : -half.z};
}

/// The corners of each face in turn, in the order of enum Face.
constexpr int face_corners[6][4] = {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                    {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}};
constexpr Vec3 face_normals[6] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};

class ShapeArtist {
 public:
  ShapeArtist(Drawing& drawing, const Pose& pose, Vec3 up, uint32_t surface)
      : drawing_(drawing), pose_(pose), up_(up), surface_(surface) {}

  void operator()(const PlaneGeometry&) {}

  void operator()(const BoxGeometry& box) {
    for (int face = 0; face < 6; ++face) quad(box.half_extents, face);
  }

  void operator()(const ContainerGeometry& container) {
    const Vec3 half = container.half_extents;
    for (int from = 0; from < 8; ++from) {
      for (const int axis : {1, 2, 4}) {
        if (!(from & axis)) edge(corner(half, from), corner(half, from | axis));
      }
    }
    bool open[6] = {};
    for (const Opening& opening : container.openings) {
      open[static_cast<int>(opening.face)] = true;
      if (opening.region) outline(half, opening);
    }
    for (int face = 0; face < 6; ++face) {
      if (!open[face] && dot(rotate(pose_.rotation, face_normals[face]), up_) < -0.7f) quad(half, face);
    }
  }

  void operator()(const SphereGeometry& sphere) {
    drawing_.spheres.push_back({pose_.position, sphere.radius, surface_});
  }

  void operator()(const CapsuleGeometry& capsule) {
    const float y = capsule.half_height;
    drawing_.spheres.push_back({to_world(pose_, {0, y, 0}), capsule.radius, surface_});
    drawing_.spheres.push_back({to_world(pose_, {0, -y, 0}), capsule.radius, surface_});
    tube(capsule.radius, y);
  }

  void operator()(const CylinderGeometry& cylinder) {
    const float y = cylinder.half_height;
    tube(cylinder.radius, y);
    for (int i = 0; i < around; ++i) {
      for (const float side : {-y, y}) {
        flat({0, side, 0}, rim(i, cylinder.radius, side), rim(i + 1, cylinder.radius, side));
      }
    }
  }

  void operator()(const MeshGeometry& def) {
    const collision::TriangleMesh mesh = collision::load_mesh(def.file, def.scale);
    for (const auto& [a, b, c] : mesh.triangles) flat(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
  }

  void operator()(const HeightFieldGeometry& field) {
    for (int row = 0; row + 1 < field.rows; ++row) {
      for (int column = 0; column + 1 < field.columns; ++column) {
        const Corner a = field_corner(field, column, row), b = field_corner(field, column + 1, row),
                     c = field_corner(field, column, row + 1), d = field_corner(field, column + 1, row + 1);
        smooth(a, c, b);
        smooth(b, c, d);
      }
    }
  }

 private:
  Vec3 rim(int i, float radius, float y) const {
    const float angle = 2 * pi * static_cast<float>(i % around) / around;
    return {radius * std::cos(angle), y, radius * std::sin(angle)};
  }

  void tube(float radius, float half_height) {
    for (int i = 0; i < around; ++i) {
      const Vec3 n0 = rim(i, 1, 0), n1 = rim(i + 1, 1, 0);
      const Corner a{rim(i, radius, -half_height), n0}, b{rim(i + 1, radius, -half_height), n1};
      const Corner c{rim(i, radius, half_height), n0}, d{rim(i + 1, radius, half_height), n1};
      smooth(a, b, c);
      smooth(c, b, d);
    }
  }

  static Corner field_corner(const HeightFieldGeometry& field, int column, int row) {
    const auto height = [&](int i, int j) {
      i = std::min(std::max(i, 0), field.columns - 1);
      j = std::min(std::max(j, 0), field.rows - 1);
      return field.heights[static_cast<std::size_t>(j) * field.columns + i];
    };
    const float x =
        (static_cast<float>(column) - 0.5f * static_cast<float>(field.columns - 1)) * field.cell_size;
    const float z = (static_cast<float>(row) - 0.5f * static_cast<float>(field.rows - 1)) * field.cell_size;
    const Vec3 normal{height(column - 1, row) - height(column + 1, row), 2 * field.cell_size,
                      height(column, row - 1) - height(column, row + 1)};
    return {Vec3{x, height(column, row), z}, normalized_or(normal, {0, 1, 0})};
  }

  void outline(Vec3 half, const Opening& opening) {
    const int face = static_cast<int>(opening.face), axis = face / 2;
    Vec3 low = max(opening.region->lower, -half), high = min(opening.region->upper, half);
    float Vec3::*const along[] = {&Vec3::x, &Vec3::y, &Vec3::z};
    low.*along[axis] = high.*along[axis] = face % 2 ? half.*along[axis] : -(half.*along[axis]);
    const Vec3 middle = 0.5f * (low + high), size = 0.5f * (high - low);
    for (int i = 0; i < 4; ++i) {
      const int* corners = face_corners[face];
      edge(middle + corner(size, corners[i]), middle + corner(size, corners[(i + 1) % 4]));
    }
  }

  void quad(Vec3 half, int face) {
    const int* c = face_corners[face];
    flat(corner(half, c[0]), corner(half, c[1]), corner(half, c[2]));
    flat(corner(half, c[0]), corner(half, c[2]), corner(half, c[3]));
  }

  void flat(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 normal = normalized_or(cross(b - a, c - a), {0, 1, 0});
    smooth({a, normal}, {b, normal}, {c, normal});
  }

  void smooth(const Corner& a, const Corner& b, const Corner& c) {
    drawing_.triangles.push_back(
        {{to_world(pose_, a[0]), to_world(pose_, b[0]), to_world(pose_, c[0])},
         {rotate(pose_.rotation, a[1]), rotate(pose_.rotation, b[1]), rotate(pose_.rotation, c[1])},
         surface_});
  }

  void edge(Vec3 from, Vec3 to) { drawing_.edges.push_back({to_world(pose_, from), to_world(pose_, to)}); }

  Drawing& drawing_;
  Pose pose_;
  Vec3 up_;
  uint32_t surface_;
};

/// 1, 2 or 5 times a power of ten, near to `size`.
float round_length(float size) {
  const float power = std::pow(10.0f, std::floor(std::log10(size)));
  const float digit = size / power;
  return power * (digit < 1.5f ? 1.0f : digit < 3.5f ? 2.0f : digit < 7.5f ? 5.0f : 10.0f);
}

}  // namespace

void add_shape(Drawing& drawing, const ShapeDef& shape, Vec3 up, uint32_t surface) {
  std::visit(ShapeArtist(drawing, shape.pose, up, surface), shape.geometry);
}

void add_ground(Drawing& drawing, const ShapeDef& shape, Vec3 up, float size) {
  const auto* plane = std::get_if<PlaneGeometry>(&shape.geometry);
  if (!plane) return;
  const Vec3 normal = normalized_or(plane->normal, up);
  const Vec3 world_normal = rotate(shape.pose.rotation, normal);
  if (dot(world_normal, up) < 0.5f) return;
  const float distance = plane->offset / std::max(length(plane->normal), 1e-20f);
  const uint32_t surface = drawing.add_surface({{0.44f, 0.45f, 0.46f}, 0});
  drawing.add_surface({{0.35f, 0.36f, 0.38f}, 0});
  drawing.grounds.push_back(
      {to_world(shape.pose, distance * normal), world_normal, round_length(size / 6), surface});
}

}  // namespace meniscus::io
