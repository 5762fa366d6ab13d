// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// 3×3 matrices for kernels.
#pragma once

#include "pbd/math/vec.h"

namespace meniscus {

/// Stored by rows.
struct Mat3 {
  Vec3 x, y, z;
};

/// A symmetric matrix.
struct Sym3 {
  float xx, yy, zz, xy, xz, yz;
};

MENISCUS_HD constexpr Vec3 operator*(const Mat3& m, Vec3 v) {
  return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}
MENISCUS_HD constexpr Vec3 operator*(const Sym3& m, Vec3 v) {
  return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
          m.xz * v.x + m.yz * v.y + m.zz * v.z};
}
/// mᵀ v
MENISCUS_HD constexpr Vec3 transposed_times(const Mat3& m, Vec3 v) {
  return v.x * m.x + v.y * m.y + v.z * m.z;
}
MENISCUS_HD constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
  return {transposed_times(b, a.x), transposed_times(b, a.y), transposed_times(b, a.z)};
}
MENISCUS_HD constexpr Mat3 operator*(const Mat3& a, const Sym3& b) {
  return {b * a.x, b * a.y, b * a.z};
}
/// a bᵀ
MENISCUS_HD constexpr Mat3 times_transposed(const Mat3& a, const Mat3& b) {
  return {b * a.x, b * a.y, b * a.z};
}
/// a bᵀ, if it is known to be symmetric
MENISCUS_HD constexpr Sym3 symmetric_product(const Mat3& a, const Mat3& b) {
  return {dot(a.x, b.x), dot(a.y, b.y), dot(a.z, b.z), dot(a.x, b.y), dot(a.x, b.z), dot(a.y, b.z)};
}
/// a diag(d)
MENISCUS_HD constexpr Mat3 times_diagonal(const Mat3& a, Vec3 d) {
  return {{a.x.x * d.x, a.x.y * d.y, a.x.z * d.z},
          {a.y.x * d.x, a.y.y * d.y, a.y.z * d.z},
          {a.z.x * d.x, a.z.y * d.y, a.z.z * d.z}};
}
MENISCUS_HD constexpr Mat3 operator-(const Mat3& a, const Mat3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
MENISCUS_HD constexpr Sym3 operator+(const Sym3& a, const Sym3& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}
MENISCUS_HD constexpr Sym3 operator-(const Sym3& a, const Sym3& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.xz - b.xz, a.yz - b.yz};
}

MENISCUS_HD constexpr Sym3 operator*(float s, const Sym3& a) {
  return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.xz, s * a.yz};
}
MENISCUS_HD constexpr Sym3 diagonal(float s) {
  return {s, s, s, 0, 0, 0};
}
/// a b, if it is known to be symmetric
MENISCUS_HD constexpr Sym3 commuting_product(const Sym3& a, const Sym3& b) {
  return {a.xx * b.xx + a.xy * b.xy + a.xz * b.xz, a.xy * b.xy + a.yy * b.yy + a.yz * b.yz,
          a.xz * b.xz + a.yz * b.yz + a.zz * b.zz, a.xx * b.xy + a.xy * b.yy + a.xz * b.yz,
          a.xx * b.xz + a.xy * b.yz + a.xz * b.zz, a.xy * b.xz + a.yy * b.yz + a.yz * b.zz};
}

/// s + [v]×, where [v]× a = v × a
MENISCUS_HD constexpr Mat3 cross_matrix(Vec3 v, float s) {
  return {{s, -v.z, v.y}, {v.z, s, -v.x}, {-v.y, v.x, s}};
}

/// −mᵀ
MENISCUS_HD constexpr Mat3 minus_transposed(const Mat3& m) {
  return {{-m.x.x, -m.y.x, -m.z.x}, {-m.x.y, -m.y.y, -m.z.y}, {-m.x.z, -m.y.z, -m.z.z}};
}

/// The axes of a frame, as columns.
MENISCUS_HD constexpr Mat3 rotation_matrix(Quat q) {
  const float x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
  return {{1 - q.y * y2 - q.z * z2, q.x * y2 - q.w * z2, q.x * z2 + q.w * y2},
          {q.x * y2 + q.w * z2, 1 - q.x * x2 - q.z * z2, q.y * z2 - q.w * x2},
          {q.x * z2 - q.w * y2, q.y * z2 + q.w * x2, 1 - q.x * x2 - q.y * y2}};
}

/// r s rᵀ
MENISCUS_HD constexpr Sym3 turned(const Mat3& r, const Sym3& s) {
  return symmetric_product(r * s, r);
}

/// The inverse of a positive definite matrix. It is scaled first: the cubes of very small elements would
/// leave the range of a float.
MENISCUS_HD constexpr Sym3 inverse(const Sym3& a) {
  const float scale = 1 / (a.xx + a.yy + a.zz);
  const Sym3 m{scale * a.xx, scale * a.yy, scale * a.zz, scale * a.xy, scale * a.xz, scale * a.yz};
  const Sym3 adjoint{m.yy * m.zz - m.yz * m.yz, m.xx * m.zz - m.xz * m.xz, m.xx * m.yy - m.xy * m.xy,
                     m.xz * m.yz - m.xy * m.zz, m.xy * m.yz - m.xz * m.yy, m.xy * m.xz - m.xx * m.yz};
  const float s = scale / (m.xx * adjoint.xx + m.xy * adjoint.xy + m.xz * adjoint.xz);
  return {s * adjoint.xx, s * adjoint.yy, s * adjoint.zz, s * adjoint.xy, s * adjoint.xz, s * adjoint.yz};
}

}  // namespace meniscus
