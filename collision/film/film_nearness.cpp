// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of FilmNearness.
#include "collision/film/film_nearness.h"

#include <algorithm>

#include "collision/film/tuning.h"

namespace meniscus::collision {

void FilmNearness::set(std::span<const Shape> shapes, uint32_t fixed, const FilmSurfaces& surfaces,
                       uint32_t worlds) {
  worlds_ = worlds;
  fixed_.assign(shapes.begin(), shapes.begin() + fixed);
  radius_.clear();
  for (const FilmRange& range : surfaces.bodies) {
    float radius = -1;
    for (uint32_t v = range.first_vertex; v < range.vertex_end; ++v)
      radius = std::max(radius, length(surfaces.vertices[v]));
    radius_.push_back(radius);
  }
  has_others_ = std::any_of(shapes.begin() + fixed, shapes.end(),
                            [&](const Shape& s) { return s.body >= radius_.size() || radius_[s.body] < 0; });
}

bool FilmNearness::any(std::span<const RigidMotion> motions, float dt, float reach) const {
  const size_t bodies = radius_.size(), each = bodies / worlds_;
  if (has_others_ || bodies * (each + fixed_.size()) > film_tuning::most_pairs) return true;
  for (size_t first = 0; first < bodies; first += each)
    if (any_in(motions, first, first + each, dt, reach)) return true;
  return false;
}

/// The same for the bodies of one world.
bool FilmNearness::any_in(std::span<const RigidMotion> motions, size_t first, size_t end, float dt,
                          float reach) const {
  const auto centre = [&](size_t b) { return motions[b].start.position + dt * motions[b].velocity; };
  const auto is_near = [&](const Shape& shape, Vec3 c, float far) {
    if (shape.kind == ShapeKind::plane) return dot(shape.size, c) - shape.offset <= far;
    return length(c - max(shape.bounds.lower, min(c, shape.bounds.upper))) <= far;
  };
  for (size_t a = first; a < end; ++a) {
    if (radius_[a] < 0) continue;
    const Vec3 c = centre(a);
    const float far = radius_[a] + reach;
    if (std::any_of(fixed_.begin(), fixed_.end(), [&](const Shape& s) { return is_near(s, c, far); }))
      return true;
    for (size_t b = first; b < a; ++b)
      if (radius_[b] >= 0 && length(c - centre(b)) <= far + radius_[b]) return true;
  }
  return false;
}

}  // namespace meniscus::collision
