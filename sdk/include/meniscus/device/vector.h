// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Arithmetic of vectors in constraints of the user.
#pragma once

#include <meniscus/device/qualifiers.h>
#include <meniscus/types.h>

#include <cmath>

namespace meniscus::device {

/// a + b
MENISCUS_BOTH_DEVICES inline Vec3 sum(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
/// a − b
MENISCUS_BOTH_DEVICES inline Vec3 difference(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// s · a
MENISCUS_BOTH_DEVICES inline Vec3 product(float s, Vec3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
/// a · b
MENISCUS_BOTH_DEVICES inline float inner(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// a × b
MENISCUS_BOTH_DEVICES inline Vec3 outer(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// |a|
MENISCUS_BOTH_DEVICES inline float norm(Vec3 a) {
  return std::sqrt(inner(a, a));
}

}  // namespace meniscus::device
