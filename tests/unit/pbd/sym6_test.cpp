// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "pbd/math/sym6.h"

#include <gtest/gtest.h>

namespace meniscus::tests {
namespace {

/// A body of 0.07 kg with particles that ride on it.
Sym6 loaded_mass() {
  Sym6 m{};
  m.add({{1, 0, 0}, {0, 0, 0}}, 0.07f);
  m.add({{0, 1, 0}, {0, 0, 0}}, 0.07f);
  m.add({{0, 0, 1}, {0, 0, 0}}, 0.07f);
  m.add({{0, 0, 0}, {1, 0, 0}}, 0.002f);
  m.add({{0, 0, 0}, {0, 1, 0}}, 0.003f);
  m.add({{0, 0, 0}, {0, 0, 1}}, 0.002f);
  for (const float x : {-0.3f, -0.1f, 0.2f}) {
    const Vec3 n{0, 1, 0}, arm{x, -0.1f, 0.5f * x + 0.05f};
    m.add({n, cross(arm, n)}, 6);
  }
  return m;
}

TEST(Sym6, TheInverseUndoesTheMatrix) {
  const Sym6 m = loaded_mass(), inverted = inverse(m);
  const Six v{{1, -2, 3}, {-0.5f, 4, 0.25f}}, back = inverted * (m * v), error = back - v;
  EXPECT_LT(length(error.linear), 1e-3f);
  EXPECT_LT(length(error.angular), 1e-3f);
}

TEST(Sym6, ASumOfProductsIsSymmetric) {
  const Sym6 m = loaded_mass();
  const Six a{{1, 2, 3}, {4, 5, 6}}, b{{-2, 1, 0}, {3, -1, 2}};
  EXPECT_FLOAT_EQ(dot(a, m * b), dot(b, m * a));
}

}  // namespace
}  // namespace meniscus::tests
