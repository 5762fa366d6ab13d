// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The vocabulary of the public interface: plain values, SI units, right-handed axes, y up unless gravity says
// otherwise.
#pragma once

#include <cstdint>

namespace meniscus {

/// A point, a vector, or one number for each axis.
struct Vec3 {
  float x, y, z;  ///< along the axes
};

/// Rotation; (0, 0, 0, 1) is none.
struct Quat {
  float x, y, z, w;  ///< w is the scalar part
};

/// Axis-aligned box, in metres.
struct Aabb {
  Vec3 lower, upper;  ///< its corners
};

/// Rigid placement: a point q of the local frame sits at position + rotation · q.
struct Pose {
  Vec3 position{0, 0, 0};     ///< m, of the frame's origin
  Quat rotation{0, 0, 0, 1};  ///< of the frame
};

/// Two objects collide if each one's group is in the other's mask.
struct CollisionFilter {
  uint32_t groups = 1;          ///< bits: the groups of this object
  uint32_t mask = 0xffffffffu;  ///< bits: the groups that it collides with

  friend bool operator==(const CollisionFilter&, const CollisionFilter&) = default;
};

}  // namespace meniscus
