// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "sdk/io/box_faces.h"
#include "sdk/io/solid_triangles.h"
#include "sdk/render/mesh.h"
#include "sdk/render/tube.h"

namespace meniscus::render {
namespace {

constexpr Vec3 glass_color{0.75f, 0.86f, 0.90f}, edge_color{0.62f, 0.70f, 0.74f};

Float4 paint(Vec3 color, Look look) {
  return float4(color, 0.5f * static_cast<float>(look));
}

void add(Triangles& all, const io::SolidTriangle& t, Float4 color) {
  for (int k = 0; k < 3; ++k) all.push_back({t.corners[k], t.normals[k], color});
}

bool faces_up(const io::SolidTriangle& t, const Pose& pose, Vec3 up) {
  return dot(rotate(pose.rotation, t.normals[0]), up) > 0.7f;
}

void add_bar(Triangles& all, Vec3 from, Vec3 to, float radius) {
  const Vec3 line[] = {from, to};
  add_tube(all, line, radius, paint(edge_color, Look::glossy));
}

void add_outline(Triangles& all, Vec3 half, const Opening& opening, float radius) {
  const int face = static_cast<int>(opening.face), axis = face / 2;
  Vec3 low = max(opening.region->lower, -half), high = min(opening.region->upper, half);
  float Vec3::*const along[] = {&Vec3::x, &Vec3::y, &Vec3::z};
  low.*along[axis] = high.*along[axis] = face % 2 ? half.*along[axis] : -(half.*along[axis]);
  const Vec3 middle = 0.5f * (low + high), size = 0.5f * (high - low);
  const int* corners = io::box_face_corners[face];
  for (int i = 0; i < 4; ++i) {
    add_bar(all, middle + io::box_corner(size, corners[i]),
            middle + io::box_corner(size, corners[(i + 1) % 4]), radius);
  }
}

}  // namespace

Triangles solid_surface(const Geometry& geometry, const Pose& pose, Vec3 up, Vec3 color) {
  Triangles all;
  const bool floors_alone = std::holds_alternative<ContainerGeometry>(geometry);
  for (const io::SolidTriangle& t : io::solid_triangles(geometry)) {
    if (!floors_alone)
      add(all, t, paint(color, Look::glossy));
    else if (faces_up(t, pose, up))
      add(all, t, paint({0.24f, 0.25f, 0.26f}, Look::tiles));
  }
  return all;
}

Triangles glass_walls(const Geometry& geometry, const Pose& pose, Vec3 up) {
  Triangles all;
  if (!std::holds_alternative<ContainerGeometry>(geometry)) return all;
  for (const io::SolidTriangle& t : io::solid_triangles(geometry)) {
    if (!faces_up(t, pose, up)) add(all, t, paint(glass_color, Look::glossy));
  }
  return all;
}

Triangles container_edges(const Geometry& geometry, float radius) {
  Triangles all;
  const auto* container = std::get_if<ContainerGeometry>(&geometry);
  if (!container) return all;
  const Vec3 half = container->half_extents;
  for (int from = 0; from < 8; ++from) {
    for (const int axis : {1, 2, 4}) {
      if (!(from & axis)) add_bar(all, io::box_corner(half, from), io::box_corner(half, from | axis), radius);
    }
  }
  for (const Opening& opening : container->openings) {
    if (opening.region) add_outline(all, half, opening, radius);
  }
  return all;
}

}  // namespace meniscus::render
