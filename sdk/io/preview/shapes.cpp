// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Turns solids and grounds into triangles and edges of the preview.
#include "sdk/io/preview/shapes.h"

#include <algorithm>
#include <cmath>

#include "sdk/io/box_faces.h"
#include "sdk/io/solid_triangles.h"

namespace meniscus::io {
namespace {

class SolidArtist {
 public:
  SolidArtist(Drawing& drawing, const Pose& pose, Vec3 up, uint32_t surface)
      : drawing_(drawing), pose_(pose), up_(up), surface_(surface) {}

  void draw(const Geometry& geometry) {
    if (const auto* container = std::get_if<ContainerGeometry>(&geometry)) {
      frame(*container);
    } else if (const auto* ball = std::get_if<SphereGeometry>(&geometry)) {
      drawing_.spheres.push_back({pose_.position, ball->radius, surface_});
    } else {
      for (const SolidTriangle& t : solid_triangles(geometry)) triangle(t);
    }
  }

 private:
  void frame(const ContainerGeometry& container) {
    const Vec3 half = container.half_extents;
    for (int from = 0; from < 8; ++from) {
      for (const int axis : {1, 2, 4}) {
        if (!(from & axis)) edge(box_corner(half, from), box_corner(half, from | axis));
      }
    }
    bool open[6] = {};
    for (const Opening& opening : container.openings) {
      open[static_cast<int>(opening.face)] = true;
      if (opening.region) outline(half, opening);
    }
    for (int face = 0; face < 6; ++face) {
      if (!open[face] && dot(rotate(pose_.rotation, box_face_normals[face]), up_) < -0.7f) floor(half, face);
    }
  }

  void outline(Vec3 half, const Opening& opening) {
    const int face = static_cast<int>(opening.face), axis = face / 2;
    Vec3 low = max(opening.region->lower, -half), high = min(opening.region->upper, half);
    float Vec3::*const along[] = {&Vec3::x, &Vec3::y, &Vec3::z};
    low.*along[axis] = high.*along[axis] = face % 2 ? half.*along[axis] : -(half.*along[axis]);
    const Vec3 middle = 0.5f * (low + high), size = 0.5f * (high - low);
    for (int i = 0; i < 4; ++i) {
      const int* corners = box_face_corners[face];
      edge(middle + box_corner(size, corners[i]), middle + box_corner(size, corners[(i + 1) % 4]));
    }
  }

  void floor(Vec3 half, int face) {
    const int* c = box_face_corners[face];
    const Vec3 in = -box_face_normals[face];
    for (const int k : {1, 2}) {
      triangle({{box_corner(half, c[0]), box_corner(half, c[k]), box_corner(half, c[k + 1])}, {in, in, in}});
    }
  }

  void triangle(const SolidTriangle& t) {
    Triangle world{{}, {}, surface_};
    for (int k = 0; k < 3; ++k) {
      world.corners[k] = to_world(pose_, t.corners[k]);
      world.normals[k] = rotate(pose_.rotation, t.normals[k]);
    }
    drawing_.triangles.push_back(world);
  }

  void edge(Vec3 from, Vec3 to) { drawing_.edges.push_back({to_world(pose_, from), to_world(pose_, to)}); }

  Drawing& drawing_;
  const Pose& pose_;
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

void add_solid(Drawing& drawing, const Geometry& geometry, const Pose& pose, Vec3 up, uint32_t surface) {
  SolidArtist(drawing, pose, up, surface).draw(geometry);
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
