// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the smoothing kernels against their integrals.
#include "fluid/kernel/kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace meniscus::fluid {
namespace {

/// ∫ f(r) over the ball of radius h.
template <class Function>
double integrate(double h, const Function& f) {
  const int shells = 20000;
  double total = 0;
  for (int k = 0; k < shells; ++k) {
    const double r = h * (k + 0.5) / shells;
    total += f(r) * 4 * std::numbers::pi * r * r * h / shells;
  }
  return total;
}

/// What loops over neighbours add up, of a pair at distance r.
double weight(const Kernel& k, double r) {
  return k.peak_weight * Kernel::weight_shape(static_cast<float>(r * r) * k.inverse_h2);
}
double slope(const Kernel& k, double r) {
  const float t = static_cast<float>(r * r) * k.inverse_h2;
  return k.peak_slope * Kernel::slope_shape(t, 1 / std::sqrt(t));
}

class KernelTest : public testing::TestWithParam<double> {};  // the ratio of support radius to spacing

TEST_P(KernelTest, Poly6IntegratesToOne) {
  const double s = 0.05, h = GetParam() * s;
  const Kernel k = calibrate(s, h);
  const double integral = integrate(h, [&](double r) { return weight(k, r); });
  EXPECT_NEAR(integral / k.volume, 1, 1e-4);
}

TEST_P(KernelTest, ByShapeOrByDistanceTheWeightIsTheSame) {
  const Kernel k = calibrate(0.05, GetParam() * 0.05);
  for (double x = 0; x < 1; x += 0.05) {
    const double r = x * k.h;
    EXPECT_NEAR(weight(k, r), k.weight(static_cast<float>(r * r)), 1e-5 * k.peak_weight);
  }
}

TEST_P(KernelTest, ThePullIsTheSlopeTimesAUnitVector) {
  const Kernel k = calibrate(0.05, GetParam() * 0.05);
  const pbd::Vec3Of<float> d{0.3f * k.h, -0.2f * k.h, 0.5f * k.h};
  const float t = k.distance_ratio2(d), inverse_root = 1 / std::sqrt(t);
  EXPECT_NEAR(t, 0.38, 1e-6);
  const float pull = k.peak_pull * Kernel::slope_shape(t, inverse_root) * inverse_root * d.x;
  const double expected = slope(k, std::sqrt(0.38) * k.h) * 0.3 / std::sqrt(0.38);
  EXPECT_NEAR(pull, expected, 1e-5 * expected);
}

// Spiky is 15 / (π h⁶) (h − r)³; its slope, integrated against −r/3, gives back the kernel's integral.
TEST_P(KernelTest, SpikyIntegratesToOne) {
  const double s = 0.05, h = GetParam() * s;
  const Kernel k = calibrate(s, h);
  const double factor = k.spiky_gradient / (45 / (std::numbers::pi * std::pow(h, 6)));
  const double integral = integrate(h, [&](double r) { return r / 3 * slope(k, r); });
  EXPECT_NEAR(integral / factor, 1, 1e-4);
}

TEST_P(KernelTest, TheSlopeIsTheFiniteDifferenceOfSpiky) {
  const double s = 0.05, h = GetParam() * s;
  const Kernel k = calibrate(s, h);
  const double factor = k.spiky_gradient / (45 / (std::numbers::pi * std::pow(h, 6)));
  const auto spiky = [&](double r) { return 15 / (std::numbers::pi * std::pow(h, 6)) * std::pow(h - r, 3); };
  for (double x = 0.05; x < 0.95; x += 0.1) {
    const double r = x * h, dr = 1e-5 * h;
    const double difference = (spiky(r - dr) - spiky(r + dr)) / (2 * dr);
    EXPECT_NEAR(slope(k, r) / factor, difference, 1e-5 * difference);
  }
}

TEST_P(KernelTest, OnTheRestLatticeTheWeightsAddUpToOneAndTheGradientIsExact) {
  const double s = 0.05, h = GetParam() * s;
  const Kernel k = calibrate(s, h);
  double sum = 0, gradient = 0, gradient2 = 0;
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      for (int z = -3; z <= 3; ++z) {
        const double r = s * std::sqrt(x * x + y * y + z * z);
        sum += weight(k, r);
        if (r == 0) continue;
        const double e = slope(k, r);
        gradient += e * (z * s) * (z * s) / r;
        gradient2 += e * e;
      }
    }
  }
  EXPECT_NEAR(sum, 1, 2e-6);
  EXPECT_NEAR(gradient, 1, 2e-6);
  EXPECT_NEAR(gradient2 / k.rest_gradient2, 1, 2e-6);
}

TEST_P(KernelTest, TheVolumeIsNearlyTheCubeOfTheSpacing) {
  const Kernel k = calibrate(0.05, GetParam() * 0.05);
  EXPECT_NEAR(k.volume / std::pow(0.05, 3), 1, 0.1);
}

TEST_P(KernelTest, AScaledLatticeHasTheSameKernel) {
  const Kernel small = calibrate(1e-3, GetParam() * 1e-3), large = calibrate(10, GetParam() * 10);
  for (float x = 0; x < 1; x += 0.1f) {
    const double a = weight(small, x * small.h), b = weight(large, x * large.h);
    EXPECT_NEAR(a, b, 1e-5 * b);
    if (x == 0) continue;
    const double da = slope(small, x * small.h) * small.h, db = slope(large, x * large.h) * large.h;
    EXPECT_NEAR(da, db, 1e-5 * db);
  }
}

TEST_P(KernelTest, NothingIsFeltBeyondTheSupport) {
  const Kernel k = calibrate(0.05, GetParam() * 0.05);
  EXPECT_EQ(k.weight(k.h2), 0);
  EXPECT_EQ(k.weight(1e30f), 0);
  for (float t : {1.0f, 1.5f, 1e32f}) {
    EXPECT_EQ(Kernel::weight_shape(t), 0);
    EXPECT_EQ(Kernel::slope_shape(t, 1 / std::sqrt(t)), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Ratios, KernelTest, testing::Values(1.5, 1.75, 2.0, 2.5, 3.0));

}  // namespace
}  // namespace meniscus::fluid
