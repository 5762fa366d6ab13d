// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A quick test on the host of whether any gap may be narrow enough for a film.
#pragma once

#include <span>
#include <vector>

#include "collision/contact/shape.h"
#include "collision/film/film_surface.h"
#include "collision/rigid/rigid_motion.h"

namespace meniscus::collision {

/// Knows the solids of a world by spheres around bodies, boxes and planes.
class FilmNearness {
 public:
  /// Fixed shapes come first among `shapes`. Bodies come world after world, as many in each.
  void set(std::span<const Shape> shapes, uint32_t fixed, const FilmSurfaces& surfaces, uint32_t worlds = 1);
  /// Whether a body with a surface may be within `reach` (m) of another solid, where the motions lead in dt.
  bool any(std::span<const RigidMotion> motions, float dt, float reach) const;

 private:
  bool any_in(std::span<const RigidMotion> motions, size_t first, size_t end, float dt, float reach) const;

  std::vector<Shape> fixed_;
  std::vector<float> radius_;  // m, by body; negative: it has no surface
  size_t worlds_ = 1;
  bool has_others_ = false;  // whether bodies without surfaces carry shapes: they may be anywhere
};

}  // namespace meniscus::collision
