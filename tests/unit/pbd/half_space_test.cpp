// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The closed forms against slow integration of the kernel over the solid.
#include "pbd/math/half_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace meniscus::pbd {
namespace {

/// ∫ W_poly6 over the solid below z = −x + curve(ρ), h = 1: rings of radius ρ, Gauss's rule not needed.
template <class Curve>
double integrate(double x, const Curve& curve) {
  const int rings = 400, layers = 400;
  double total = 0;
  for (int i = 0; i < rings; ++i) {
    const double rho = (i + 0.5) / rings;
    const double half = std::sqrt(1 - rho * rho), top = std::clamp(-x + curve(rho), -half, half);
    double ring = 0;
    for (int j = 0; j < layers; ++j) {
      const double z = -half + (top + half) * (j + 0.5) / layers;
      ring += std::pow(1 - rho * rho - z * z, 3) * (top + half) / layers;
    }
    total += ring * 2 * std::numbers::pi * rho / rings;
  }
  return total * 315 / (64 * std::numbers::pi);
}

TEST(HalfSpace, TheClosedFormIsTheIntegral) {
  for (double x = -1; x <= 1; x += 0.125) {
    EXPECT_NEAR(half_space_density(static_cast<float>(x)), integrate(x, [](double) { return 0.0; }), 2e-5);
  }
}

TEST(HalfSpace, ItEndsWhereTheSupportEnds) {
  EXPECT_NEAR(half_space_density(-1.0f), 1, 1e-6);
  EXPECT_NEAR(half_space_density(0.0f), 0.5, 1e-6);
  EXPECT_NEAR(half_space_density(1.0f), 0, 1e-6);
  EXPECT_EQ(half_space_density(7.0f), half_space_density(1.0f));
  EXPECT_EQ(half_space_density(-7.0f), half_space_density(-1.0f));
}

TEST(HalfSpace, ItFallsWithTheDistance) {
  for (float x = -1; x < 0.99f; x += 0.01f)
    EXPECT_GT(half_space_density(x), half_space_density(x + 0.01f) - 2e-7f);
}

TEST(HalfSpace, CurvatureIsRightToFirstOrder) {
  const float curvature = 0.05f;  // mean curvature times h; a sphere's is its inverse radius
  for (double x = -0.75; x <= 0.75; x += 0.25) {
    const double flat = integrate(x, [](double) { return 0.0; });
    const double sag = integrate(x, [&](double rho) { return -0.5 * curvature * rho * rho; });
    const double found =
        half_space_density(static_cast<float>(x), curvature) - half_space_density(static_cast<float>(x));
    EXPECT_NEAR(found, sag - flat, 0.05 * std::fabs(sag - flat) + 1e-5) << "x = " << x;
  }
}

TEST(HalfSpace, AStrongCurvatureStaysAShare) {
  for (float curvature : {-20.0f, -3.0f, 3.0f, 20.0f}) {
    for (float x = -1; x <= 1; x += 0.1f) {
      EXPECT_GE(half_space_density(x, curvature), 0);
      EXPECT_LE(half_space_density(x, curvature), 1);
    }
  }
}

}  // namespace
}  // namespace meniscus::pbd
