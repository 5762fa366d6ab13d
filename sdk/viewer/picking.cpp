// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Casts rays at solids, particles, cloth and ropes.
#include "sdk/viewer/picking.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus::viewer {
namespace {

constexpr float nowhere = std::numeric_limits<float>::infinity();
constexpr float hold_radius = 0.75f;  // spacings: no ray passes between particles at rest
constexpr float handful =
    2.5f;  // spacings: particles within this distance of the one under the mouse are held as well

/// Distance along the ray to a triangle, from either side (Möller & Trumbore 1997).
float meet_triangle(const Ray& ray, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, ac = c - a, p = cross(ray.direction, ac);
  const float volume = dot(ab, p);
  if (std::abs(volume) < 1e-20f) return nowhere;
  const Vec3 from_a = ray.from - a, q = cross(from_a, ab);
  const float u = dot(from_a, p) / volume, v = dot(ray.direction, q) / volume;
  if (u < 0 || v < 0 || u + v > 1) return nowhere;
  const float along = dot(ac, q) / volume;
  return along > 0 ? along : nowhere;
}

float meet_ball(const Ray& ray, Vec3 centre, float radius) {
  const Vec3 to = centre - ray.from;
  const float along = dot(to, ray.direction), off2 = dot(to, to) - along * along;
  return along > radius && off2 < radius * radius ? along - std::sqrt(radius * radius - off2) : nowhere;
}

float meet_triangles(const Ray& ray, const Pose& pose, const std::vector<io::SolidTriangle>& triangles) {
  const Ray local{to_local(pose, ray.from), rotate(conjugate(pose.rotation), ray.direction)};
  float nearest = nowhere;
  for (const io::SolidTriangle& t : triangles)
    nearest = std::min(nearest, meet_triangle(local, t.corners[0], t.corners[1], t.corners[2]));
  return nearest;
}

HeldParticles handful_of(const Snapshot& s, Vec3 point, float radius) {
  HeldParticles held;
  for (std::size_t i = 0; i < s.positions.size(); ++i) {
    const Vec3 place = s.positions[i] - point;
    if (dot(place, place) > radius * radius) continue;
    held.ids.push_back(s.ids[i]);
    held.places.push_back(place);
  }
  return held;
}

/// The vertices of one piece, given by its range of numbers in the frame, that are near a point; at least
/// one.
HeldVertices patch_of(const std::vector<Vec3>& x, uint32_t first, uint32_t end, Vec3 point, float radius) {
  HeldVertices held;
  uint32_t nearest = first;
  for (uint32_t v = first; v < end; ++v) {
    const Vec3 place = x[v] - point;
    if (length(place) < length(x[nearest] - point)) nearest = v;
    if (length(place) > radius) continue;
    held.vertices.push_back(v - first);
    held.places.push_back(place);
  }
  if (held.vertices.empty()) {
    held.vertices.push_back(nearest - first);
    held.places.push_back(x[nearest] - point);
  }
  return held;
}

HeldVertices patch_of_cloth(const io::ClothFrame& frame, std::size_t triangle, Vec3 point) {
  const auto& t = frame.triangles[triangle];
  const uint32_t piece = frame.pieces[triangle];
  const auto is_its = [&](uint32_t p) { return p == piece; };
  const auto begin = std::find_if(frame.vertex_pieces.begin(), frame.vertex_pieces.end(), is_its);
  const auto end = std::find_if_not(begin, frame.vertex_pieces.end(), is_its);
  const float edge = length(frame.vertices[t[1]] - frame.vertices[t[0]]);
  HeldVertices held = patch_of(frame.vertices, static_cast<uint32_t>(begin - frame.vertex_pieces.begin()),
                               static_cast<uint32_t>(end - frame.vertex_pieces.begin()), point, 2.1f * edge);
  held.index = piece;
  return held;
}

/// The nearest hit so far.
struct Nearest {
  float along = nowhere;
  enum class Kind { nothing, particle, body, cloth, rope } kind = Kind::nothing;
  std::size_t index = 0;

  void offer(float at, Kind what, std::size_t number) {
    if (at >= along) return;
    along = at;
    kind = what;
    index = number;
  }
};

void look_along_ropes(const Ray& ray, const io::RopeFrame& ropes, Nearest& nearest) {
  for (std::size_t r = 0; r < ropes.lines.size(); ++r) {
    for (const uint32_t v : ropes.lines[r]) {
      // Ropes are thin, so a ray may miss them by a little.
      const float away = length(ropes.vertices[v] - ray.from);
      nearest.offer(meet_ball(ray, ropes.vertices[v], std::max(2 * ropes.radii[r], 0.012f * away)),
                    Nearest::Kind::rope, r);
    }
  }
}

}  // namespace

Picker::Picker(const Scene& scene) : spacing_(scene.world.particle_spacing) {
  for (const ShapeDef& shape : scene.shapes) {
    if (std::holds_alternative<ContainerGeometry>(shape.geometry)) continue;
    shapes_.push_back({io::solid_triangles(shape.geometry), shape.pose, false});
  }
  for (const BodyDef& body : bodies_of(scene))
    bodies_.push_back({io::solid_triangles(body.geometry), {}, body.motion == BodyMotion::dynamic});
}

std::optional<Grab> Picker::pick(const Ray& ray, const Snapshot& s) const {
  using Kind = Nearest::Kind;
  Nearest nearest;
  for (const Solid& shape : shapes_)
    nearest.offer(meet_triangles(ray, shape.pose, shape.triangles), Kind::nothing, 0);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    nearest.offer(meet_triangles(ray, s.bodies[i].pose, bodies_[i].triangles),
                  bodies_[i].moves ? Kind::body : Kind::nothing, i);
  }
  for (std::size_t i = 0; i < s.positions.size(); ++i)
    nearest.offer(meet_ball(ray, s.positions[i], hold_radius * spacing_), Kind::particle, i);
  for (std::size_t i = 0; i < s.cloth.triangles.size(); ++i) {
    const auto& t = s.cloth.triangles[i];
    nearest.offer(meet_triangle(ray, s.cloth.vertices[t[0]], s.cloth.vertices[t[1]], s.cloth.vertices[t[2]]),
                  Kind::cloth, i);
  }
  look_along_ropes(ray, s.ropes, nearest);

  const Vec3 point = ray.from + nearest.along * ray.direction;
  switch (nearest.kind) {
    case Kind::nothing:
      return {};
    case Kind::particle:
      return Grab{handful_of(s, s.positions[nearest.index], handful * spacing_), s.positions[nearest.index]};
    case Kind::body:
      return Grab{HeldBody{nearest.index, to_local(s.bodies[nearest.index].pose, point)}, point};
    case Kind::cloth:
      return Grab{patch_of_cloth(s.cloth, nearest.index, point), point};
    case Kind::rope:
      break;
  }
  const std::vector<uint32_t>& line = s.ropes.lines[nearest.index];
  const auto [first, last] = std::minmax_element(line.begin(), line.end());
  HeldVertices held = patch_of(s.ropes.vertices, *first, *last + 1, point, 0);
  held.of_rope = true;
  held.index = nearest.index;
  return Grab{held, point};
}

}  // namespace meniscus::viewer
