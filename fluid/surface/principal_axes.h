// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Eigenvalues and eigenvectors of a symmetric 3 × 3 matrix, for kernels.
#pragma once

#include "fluid/surface/tuning.h"
#include "pbd/math/vec.h"

namespace meniscus::fluid {

/// A symmetric 3 × 3 matrix.
struct Symmetric3 {
  float xx, yy, zz, xy, xz, yz;
};

struct PrincipalAxes {
  Vec3 values;    ///< eigenvalues, in the order of the axes
  Quat rotation;  ///< takes x, y and z to the eigenvectors
};

namespace principal_axes_detail {

/// A rotation about one axis that makes `off` 0 between the diagonal elements a and b. o1 and o2 couple the
/// two to the third axis. `axis` is the component of the quaternion that the rotation changes.
MENISCUS_HD inline void turn(float& a, float& b, float& off, float& o1, float& o2, Quat& q, Vec3 axis) {
  if (fabsf(off) <= 1e-12f * (fabsf(a) + fabsf(b))) return;
  const float theta = 0.5f * (b - a) / off;
  const float t = (theta < 0 ? -1.0f : 1.0f) / (fabsf(theta) + sqrtf(theta * theta + 1));
  const float c = 1 / sqrtf(t * t + 1), s = t * c;
  a -= t * off;
  b += t * off;
  off = 0;
  const float before = o1;
  o1 = c * before - s * o2;
  o2 = s * before + c * o2;
  const float half_cosine = sqrtf(0.5f * (1 + c)), half_sine = 0.5f * s / half_cosine;
  q = q * Quat{-half_sine * axis.x, -half_sine * axis.y, -half_sine * axis.z, half_cosine};
}

}  // namespace principal_axes_detail

/// Jacobi's method: cyclic, with as many sweeps as floats need.
MENISCUS_HD inline PrincipalAxes principal_axes(Symmetric3 m) {
  using principal_axes_detail::turn;
  Quat q{0, 0, 0, 1};
  for (int sweep = 0; sweep < surface_tuning::jacobi_sweeps; ++sweep) {
    turn(m.xx, m.yy, m.xy, m.xz, m.yz, q, {0, 0, 1});
    turn(m.yy, m.zz, m.yz, m.xy, m.xz, q, {1, 0, 0});
    turn(m.zz, m.xx, m.xz, m.yz, m.xy, q, {0, 1, 0});
  }
  return {{m.xx, m.yy, m.zz}, normalized(q)};
}

}  // namespace meniscus::fluid
