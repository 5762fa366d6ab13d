// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Small vectors for kernels, over a scalar R that is float, or a pack of float lanes on the CPU
// (device/cpu/lanes.h).
#pragma once

#include <meniscus/types.h>
#include <cmath>

#include "pbd/device/base/qualifiers.h"

namespace meniscus {

namespace pbd {

// Not fmaxf and fminf, which g++ compiles to calls. The result is the second argument if the first is NaN.
MENISCUS_HD constexpr float max(float a, float b) {
  return a > b ? a : b;
}
MENISCUS_HD constexpr float min(float a, float b) {
  return a < b ? a : b;
}
MENISCUS_HD constexpr float clamp(float a, float lower, float upper) {
  return min(max(a, lower), upper);
}

}  // namespace pbd

MENISCUS_HD constexpr Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
MENISCUS_HD constexpr Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
MENISCUS_HD constexpr Vec3 operator-(Vec3 a) {
  return {-a.x, -a.y, -a.z};
}
MENISCUS_HD constexpr Vec3 operator*(float s, Vec3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
MENISCUS_HD constexpr Vec3 operator*(Vec3 a, float s) {
  return s * a;
}
MENISCUS_HD constexpr Vec3 operator/(Vec3 a, float s) {
  return {a.x / s, a.y / s, a.z / s};
}
MENISCUS_HD constexpr Vec3& operator+=(Vec3& a, Vec3 b) {
  return a = a + b;
}
MENISCUS_HD constexpr Vec3& operator-=(Vec3& a, Vec3 b) {
  return a = a - b;
}
MENISCUS_HD constexpr bool operator==(Vec3 a, Vec3 b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

MENISCUS_HD constexpr float dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
MENISCUS_HD constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
MENISCUS_HD inline float length(Vec3 a) {
  return sqrtf(dot(a, a));
}
MENISCUS_HD inline Vec3 min(Vec3 a, Vec3 b) {
  return {pbd::min(a.x, b.x), pbd::min(a.y, b.y), pbd::min(a.z, b.z)};
}
MENISCUS_HD inline Vec3 max(Vec3 a, Vec3 b) {
  return {pbd::max(a.x, b.x), pbd::max(a.y, b.y), pbd::max(a.z, b.z)};
}
MENISCUS_HD inline Vec3 abs(Vec3 a) {
  return {fabsf(a.x), fabsf(a.y), fabsf(a.z)};
}
MENISCUS_HD constexpr bool inside(const Aabb& box, Vec3 p) {
  return p.x >= box.lower.x && p.x <= box.upper.x && p.y >= box.lower.y && p.y <= box.upper.y &&
         p.z >= box.lower.z && p.z <= box.upper.z;
}
MENISCUS_HD inline float max_component(Vec3 a) {
  return pbd::max(a.x, pbd::max(a.y, a.z));
}

/// The unit vector along a, or `fallback` where a has no direction.
MENISCUS_HD inline Vec3 normalized_or(Vec3 a, Vec3 fallback) {
  const float l = length(a);
  return l > 1e-20f ? a / l : fallback;
}

/// a, shortened to the length `most` if it is longer.
MENISCUS_HD inline Vec3 shortened_to(Vec3 a, float most) {
  const float size = length(a);
  return size > most ? (most / size) * a : a;
}

MENISCUS_HD inline bool is_finite(Vec3 a) {
  // NaN and infinity both fail: x − x is 0 only for finite x.
  return (a.x - a.x) == 0 && (a.y - a.y) == 0 && (a.z - a.z) == 0;
}

MENISCUS_HD constexpr Vec3 rotate(Quat q, Vec3 v) {
  const Vec3 u{q.x, q.y, q.z};
  const Vec3 t = 2.0f * cross(u, v);
  return v + q.w * t + cross(u, t);
}
MENISCUS_HD constexpr Quat conjugate(Quat q) {
  return {-q.x, -q.y, -q.z, q.w};
}
MENISCUS_HD constexpr Quat operator*(Quat a, Quat b) {
  const Vec3 u{a.x, a.y, a.z}, v{b.x, b.y, b.z};
  const Vec3 w = a.w * v + b.w * u + cross(u, v);
  return {w.x, w.y, w.z, a.w * b.w - dot(u, v)};
}
MENISCUS_HD inline Quat normalized(Quat q) {
  const float inverse = 1 / sqrtf(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  return {inverse * q.x, inverse * q.y, inverse * q.z, inverse * q.w};
}
/// The rotation by a rotation vector: its direction is the axis, its length the angle in rad.
MENISCUS_HD inline Quat rotation_by(Vec3 turn) {
  const float angle = length(turn);
  // sin(a/2)/a; near 0 its series, whose next term is below a float's rounding.
  const float scale = angle < 0.02f ? 0.5f - angle * angle / 48 : sinf(0.5f * angle) / angle;
  return {scale * turn.x, scale * turn.y, scale * turn.z, cosf(0.5f * angle)};
}
MENISCUS_HD constexpr Vec3 to_world(const Pose& pose, Vec3 local) {
  return pose.position + rotate(pose.rotation, local);
}
MENISCUS_HD constexpr Vec3 to_local(const Pose& pose, Vec3 world) {
  return rotate(conjugate(pose.rotation), world - pose.position);
}
/// The pose of an object that is at `inner` in the frame of `outer`.
MENISCUS_HD inline Pose operator*(const Pose& outer, const Pose& inner) {
  return {to_world(outer, inner.position), normalized(outer.rotation * inner.rotation)};
}
MENISCUS_HD constexpr Pose inverse(const Pose& pose) {
  const Quat back = conjugate(pose.rotation);
  return {rotate(back, -pose.position), back};
}

namespace pbd {

template <class R>
struct Vec3Of {
  R x, y, z;
};

template <class R>
struct Vec4Of {
  R x, y, z, w;

  MENISCUS_HD Vec3Of<R> xyz() const { return {x, y, z}; }
};

/// Sixteen bytes, so that one load or store moves a particle.
struct alignas(16) Vec4 {
  float x, y, z, w;

  MENISCUS_HD constexpr Vec3 xyz() const { return {x, y, z}; }
};

MENISCUS_HD constexpr Vec4 with_w(Vec3 v, float w) {
  return {v.x, v.y, v.z, w};
}
/// p + displacement, with p's w.
MENISCUS_HD constexpr Vec4 shifted(const Vec4& p, Vec3 displacement) {
  return {p.x + displacement.x, p.y + displacement.y, p.z + displacement.z, p.w};
}

template <class R>
MENISCUS_HD Vec3Of<R> operator-(Vec3 a, const Vec3Of<R>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class R>
MENISCUS_HD Vec3Of<R> operator-(const Vec3Of<R>& a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class R>
MENISCUS_HD Vec3Of<R> operator-(const Vec3Of<R>& a, const Vec3Of<R>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class R>
MENISCUS_HD Vec3Of<R> operator-(const Vec3Of<R>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class R>
MENISCUS_HD Vec3Of<R> operator+(const Vec3Of<R>& a, const Vec3Of<R>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class R>
MENISCUS_HD Vec3Of<R> operator*(const R& s, const Vec3Of<R>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class R>
MENISCUS_HD Vec3Of<R> operator/(const Vec3Of<R>& a, const R& s) {
  return {a.x / s, a.y / s, a.z / s};
}
template <class R>
MENISCUS_HD Vec3Of<R>& operator+=(Vec3Of<R>& a, const Vec3Of<R>& b) {
  a.x += b.x;
  a.y += b.y;
  a.z += b.z;
  return a;
}
template <class R>
MENISCUS_HD R dot(const Vec3Of<R>& a, const Vec3Of<R>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class R>
MENISCUS_HD R dot(Vec3 a, const Vec3Of<R>& b) {
  return R(a.x) * b.x + R(a.y) * b.y + R(a.z) * b.z;
}
template <class R>
MENISCUS_HD Vec3Of<R> cross(const Vec3Of<R>& a, const Vec3Of<R>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace pbd
}  // namespace meniscus
