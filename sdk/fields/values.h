// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Plain values that definitions are made of: placements, boxes, ranges, filters.
#pragma once

#include <meniscus/defs.h>

#include <limits>
#include <string>

#include "pbd/math/direction.h"
#include "sdk/fields/visitor.h"

namespace meniscus {

constexpr bool ordered(Vec3 lower, Vec3 upper) {
  return lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z;
}

template <class V>
void check_corners(V& v, Vec3 lower, Vec3 upper) {
  v.check(ordered(lower, upper), "lower must not be above upper in any component", "lower", lower);
}

/// Checks that a vector can be made a unit vector.
template <class V>
void check_direction(V& v, const char* name, Vec3 value) {
  v.check(pbd::is_direction(value), std::string(name) + " must be of a length from 1e-6 to 1e18", name,
          value);
}

template <class V>
void fields(V& v, Pose& d) {
  v("position", d.position, any_value, "m", "where the origin of the local frame sits");
  v("rotation", d.rotation, any_value, "", "axis and angle, or a quaternion [x, y, z, w]");
}

template <class V>
void fields(V& v, Aabb& d) {
  v("lower", d.lower, required(any_value), "m", "least corner");
  v("upper", d.upper, required(any_value), "m", "greatest corner");
  check_corners(v, d.lower, d.upper);
}

template <class V>
void fields(V& v, Range& d) {
  v("low", d.low, not_negative, "", "where it begins");
  v("high", d.high, not_negative, "", "where it is in full");
  v.check(d.low < d.high, "low must be below high", "low", d.low);
}

/// What collides with what: keys of the fluid or solid itself.
template <class V>
void fields(V& v, CollisionFilter& d) {
  constexpr FieldRule bits = between(0, std::numeric_limits<uint32_t>::max());
  v("groups", d.groups, bits, "", "what it is, as the sum of powers of 2");
  v("mask", d.mask, bits, "",
    "which groups it collides with, as the sum of powers of 2; two things collide where each one's group is "
    "in the other's mask");
}

}  // namespace meniscus
