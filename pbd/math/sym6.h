// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Symmetric matrices of shifts and turns, for kernels.
#pragma once

#include "pbd/math/vec.h"

namespace meniscus {

/// A motion, or a force with its torque.
struct Six {
  Vec3 linear{0, 0, 0}, angular{0, 0, 0};

  MENISCUS_HD Six& operator+=(const Six& o) {
    linear += o.linear;
    angular += o.angular;
    return *this;
  }
};
MENISCUS_HD inline Six operator-(const Six& a, const Six& b) {
  return {a.linear - b.linear, a.angular - b.angular};
}
MENISCUS_HD inline float dot(const Six& a, const Six& b) {
  return dot(a.linear, b.linear) + dot(a.angular, b.angular);
}

/// The lower triangle, by rows.
struct Sym6 {
  static constexpr int size = 6;
  float value[size * (size + 1) / 2];

  MENISCUS_HD static constexpr int at(int row, int column) {
    return row >= column ? row * (row + 1) / 2 + column : column * (column + 1) / 2 + row;
  }
  /// Adds w a aᵀ.
  MENISCUS_HD void add(const Six& a, float w) {
    const float v[size] = {a.linear.x, a.linear.y, a.linear.z, a.angular.x, a.angular.y, a.angular.z};
    MENISCUS_UNROLL
    for (int r = 0; r < size; ++r) {
      MENISCUS_UNROLL
      for (int c = 0; c <= r; ++c) value[at(r, c)] += w * v[r] * v[c];
    }
  }
  MENISCUS_HD Sym6& operator+=(const Sym6& o) {
    MENISCUS_UNROLL
    for (int k = 0; k < size * (size + 1) / 2; ++k) value[k] += o.value[k];
    return *this;
  }
};

MENISCUS_HD inline Six operator*(const Sym6& m, const Six& a) {
  const float v[6] = {a.linear.x, a.linear.y, a.linear.z, a.angular.x, a.angular.y, a.angular.z};
  float out[6];
  MENISCUS_UNROLL
  for (int r = 0; r < 6; ++r) {
    float sum = 0;
    MENISCUS_UNROLL
    for (int c = 0; c < 6; ++c) sum += m.value[Sym6::at(r, c)] * v[c];
    out[r] = sum;
  }
  return {{out[0], out[1], out[2]}, {out[3], out[4], out[5]}};
}

/// The inverse of a positive definite matrix, by Cholesky's factors.
MENISCUS_HD inline Sym6 inverse(const Sym6& m) {
  constexpr int n = Sym6::size;
  Sym6 factor = m, lower{};
  for (int c = 0; c < n; ++c) {
    for (int k = 0; k < c; ++k)
      factor.value[Sym6::at(c, c)] -= factor.value[Sym6::at(c, k)] * factor.value[Sym6::at(c, k)];
    const float root = sqrtf(factor.value[Sym6::at(c, c)]);
    factor.value[Sym6::at(c, c)] = root;
    for (int r = c + 1; r < n; ++r) {
      float& v = factor.value[Sym6::at(r, c)];
      for (int k = 0; k < c; ++k) v -= factor.value[Sym6::at(r, k)] * factor.value[Sym6::at(c, k)];
      v /= root;
    }
  }
  for (int c = 0; c < n; ++c) {
    lower.value[Sym6::at(c, c)] = 1 / factor.value[Sym6::at(c, c)];
    for (int r = c + 1; r < n; ++r) {
      float sum = 0;
      for (int k = c; k < r; ++k) sum -= factor.value[Sym6::at(r, k)] * lower.value[Sym6::at(k, c)];
      lower.value[Sym6::at(r, c)] = sum / factor.value[Sym6::at(r, r)];
    }
  }
  Sym6 out{};
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c <= r; ++c) {
      float sum = 0;
      for (int k = r; k < n; ++k) sum += lower.value[Sym6::at(k, r)] * lower.value[Sym6::at(k, c)];
      out.value[Sym6::at(r, c)] = sum;
    }
  }
  return out;
}

}  // namespace meniscus
