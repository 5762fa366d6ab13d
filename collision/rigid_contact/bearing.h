// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A body that solids hold or load, within the iterations of particles.
#pragma once

#include "pbd/math/sym6.h"

namespace meniscus::collision {

/// By body. Without `moves` nothing but particles acts on it, or nothing moves it.
struct HeldBody {
  Sym6 give{};             ///< 1/kg: the inverse of its mass, with that of the particles that ride on it
  Six motion{}, before{};  ///< m and rad, beyond where it would be without particles: now, an iteration ago
  Six borne{};             ///< kg·m: what solids exert beyond what they would without particles
  uint32_t moves = 0;      // a whole word: a copy reads no padding
};

/// m: of a body's point.
MENISCUS_HD inline Vec3 motion_at(const Six& motion, Vec3 arm) {
  return motion.linear + cross(motion.angular, arm);
}

/// 1/kg: how far the point gives way along n.
MENISCUS_HD inline float give_at(const HeldBody& body, Vec3 arm, Vec3 n) {
  if (!body.moves) return 0;
  const Six row{n, cross(arm, n)};
  return dot(row, body.give * row);
}

}  // namespace meniscus::collision
