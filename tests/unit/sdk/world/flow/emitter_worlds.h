// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Emitters for tests, which make water far from anything unless told otherwise.
#pragma once

#include <numbers>

#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {

inline constexpr float emitter_spacing = 0.05f;

inline EmitterDef emitter(FluidId fluid, const EmitterOpening& opening, float speed) {
  EmitterDef def;
  def.fluid = fluid;
  def.opening = opening;
  def.speed = speed;
  return def;
}

/// m³, of what has been made.
inline double emitted_volume(const World& world, EmitterId id) {
  const double s = world.def().particle_spacing;
  return static_cast<double>(world.emitter_count(id).total) * s * s * s;
}

/// The least distance between any two particles, in spacings; 10 where there are no two so near.
inline float nearest_pair(const World& world) {
  const std::span<const Vec3> p = world.positions();
  const float s = world.def().particle_spacing;
  float nearest = 10;
  for (size_t i = 0; i < p.size(); ++i) {
    for (size_t j = 0; j < i; ++j) nearest = std::min(nearest, length(p[i] - p[j]) / s);
  }
  return nearest;
}

}  // namespace meniscus::tests
