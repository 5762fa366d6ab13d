// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Triangulates each kind of geometry.
#include "sdk/io/solid_triangles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "collision/mesh/hull.h"
#include "collision/mesh/mesh.h"
#include "pbd/math/vec.h"
#include "sdk/io/box_faces.h"
#include "sdk/world/solids/container_faces.h"

namespace meniscus::io {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr int around = 48;  // facets of round shapes, once about the axis
constexpr int arc = 12;     // rings of a quarter circle from the equator to a pole

struct Corner {
  Vec3 position, normal;
};

class Triangulation {
 public:
  std::vector<SolidTriangle> triangles;

  void operator()(const PlaneGeometry&) {}

  void operator()(const BoxGeometry& box) {
    for (const int(&c)[4] : box_face_corners) {
      flat_quad(box_corner(box.half_extents, c[0]), box_corner(box.half_extents, c[1]),
                box_corner(box.half_extents, c[2]), box_corner(box.half_extents, c[3]));
    }
  }

  void operator()(const ContainerGeometry& container) {
    for (const FacePiece& wall : container_faces(container)) {
      const Vec3 middle = 0.5f * (wall.lower + wall.upper), half = 0.5f * (wall.upper - wall.lower);
      const int* c = box_face_corners[static_cast<int>(wall.face)];
      flat_quad(middle + box_corner(half, c[3]), middle + box_corner(half, c[2]),
                middle + box_corner(half, c[1]), middle + box_corner(half, c[0]));
    }
  }

  void operator()(const SphereGeometry& sphere) {
    dome(sphere.radius, 0, 1);
    dome(sphere.radius, 0, -1);
  }

  void operator()(const CapsuleGeometry& capsule) {
    dome(capsule.radius, capsule.half_height, 1);
    dome(capsule.radius, capsule.half_height, -1);
    if (capsule.half_height > 0) tube(capsule.radius, capsule.half_height);
  }

  void operator()(const CylinderGeometry& cylinder) {
    const float y = cylinder.half_height, r = cylinder.radius;
    tube(r, y);
    for (int i = 0; i < around; ++i) {
      flat({0, y, 0}, rim(i + 1, r, y), rim(i, r, y));
      flat({0, -y, 0}, rim(i, r, -y), rim(i + 1, r, -y));
    }
  }

  void operator()(const MeshGeometry& def) {
    const collision::PaintedMesh painted = collision::load_painted_mesh(collision::MeshSource::of(def));
    mesh(painted.mesh);
    for (std::size_t i = 0; i < painted.colors.size(); ++i) triangles[i].color = painted.colors[i];
  }

  void operator()(const HullGeometry& hull) { mesh(collision::hull_mesh(hull.points)); }

  void operator()(const CompoundGeometry& compound) {
    for (const CompoundPart& part : compound.parts) {
      for (SolidTriangle t : solid_triangles(part.geometry)) {
        for (Vec3& p : t.corners) p = to_world(part.pose, p);
        for (Vec3& n : t.normals) n = rotate(part.pose.rotation, n);
        triangles.push_back(t);
      }
    }
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
  static Vec3 rim(int i, float radius, float y) {
    const float angle = 2 * pi * static_cast<float>(i % around) / around;
    return {radius * std::cos(angle), y, radius * std::sin(angle)};
  }

  void tube(float radius, float half_height) {
    for (int i = 0; i < around; ++i) {
      const Vec3 n0 = rim(i, 1, 0), n1 = rim(i + 1, 1, 0);
      const Corner a{rim(i, radius, -half_height), n0}, b{rim(i + 1, radius, -half_height), n1};
      const Corner c{rim(i, radius, half_height), n0}, d{rim(i + 1, radius, half_height), n1};
      smooth(a, c, b);
      smooth(c, d, b);
    }
  }

  /// A point of a half sphere whose pole points along side · y, on ring k of `arc`.
  static Corner dome_corner(float radius, float middle, float side, int i, int k) {
    const float lift = k == arc ? 1.0f : std::sin(0.5f * pi * static_cast<float>(k) / arc);
    const Vec3 normal = rim(i, k == arc ? 0.0f : std::sqrt(1 - lift * lift), side * lift);
    return {radius * normal + Vec3{0, side * middle, 0}, normal};
  }

  void dome(float radius, float middle, float side) {
    for (int i = 0; i < around; ++i) {
      const int from = side > 0 ? i : i + 1, to = side > 0 ? i + 1 : i;
      for (int k = 0; k < arc; ++k) {
        const Corner a = dome_corner(radius, middle, side, from, k),
                     b = dome_corner(radius, middle, side, to, k),
                     c = dome_corner(radius, middle, side, from, k + 1),
                     d = dome_corner(radius, middle, side, to, k + 1);
        smooth(a, c, b);
        if (k + 1 < arc) smooth(b, c, d);
      }
    }
  }

  void mesh(const collision::TriangleMesh& m) {
    for (const auto& [a, b, c] : m.triangles) flat(m.vertices[a], m.vertices[b], m.vertices[c]);
  }

  static Corner field_corner(const HeightFieldGeometry& field, int column, int row) {
    const auto height = [&](int i, int j) {
      i = std::clamp(i, 0, field.columns - 1);
      j = std::clamp(j, 0, field.rows - 1);
      return field.heights[static_cast<std::size_t>(j) * field.columns + i];
    };
    const float x =
        (static_cast<float>(column) - 0.5f * static_cast<float>(field.columns - 1)) * field.cell_size;
    const float z = (static_cast<float>(row) - 0.5f * static_cast<float>(field.rows - 1)) * field.cell_size;
    const Vec3 normal{height(column - 1, row) - height(column + 1, row), 2 * field.cell_size,
                      height(column, row - 1) - height(column, row + 1)};
    return {Vec3{x, height(column, row), z}, normalized_or(normal, {0, 1, 0})};
  }

  void flat_quad(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    flat(a, b, c);
    flat(a, c, d);
  }

  void flat(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 normal = normalized_or(cross(b - a, c - a), {0, 1, 0});
    triangles.push_back({{a, b, c}, {normal, normal, normal}});
  }

  void smooth(const Corner& a, const Corner& b, const Corner& c) {
    triangles.push_back({{a.position, b.position, c.position}, {a.normal, b.normal, c.normal}});
  }
};

}  // namespace

std::vector<SolidTriangle> solid_triangles(const Geometry& geometry) {
  Triangulation result;
  std::visit(result, geometry);
  return std::move(result.triangles);
}

}  // namespace meniscus::io
