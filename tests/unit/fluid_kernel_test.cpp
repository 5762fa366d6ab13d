// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "fluid/kernel.h"

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

class KernelTest : public testing::TestWithParam<double> {};  // the ratio of support radius to spacing

TEST_P(KernelTest, Poly6IntegratesToOne) {
  const double s = 0.05, h = GetParam() * s;
  const Kernel k = calibrate(s, h);
  const double integral = integrate(h, [&](double r) { return k.weight(static_cast<float>(r * r)); });
  EXPECT_NEAR(integral / k.volume, 1, 1e-4);
}

// Spiky is 15 / (π h⁶) (h − r)³; its slope, integrated against −r/3, gives back the kernel's integral.
TEST_P(KernelTest, SpikyIntegratesToOne) {
  const double s = 0.05, h = GetParam() * s;
  const Kernel k = calibrate(s, h);
  const double factor = k.spiky_gradient / (45 / (std::numbers::pi * std::pow(h, 6)));
  const double integral = integrate(h, [&](double r) { return r / 3 * k.slope(static_cast<float>(r)); });
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
    EXPECT_NEAR(k.slope(static_cast<float>(r)) / factor, difference, 1e-5 * difference);
  }
}

TEST_P(KernelTest, OnTheRestLatticeTheWeightsAddUpToOneAndTheGradientIsExact) {
  const double s = 0.05, h = GetParam() * s;
  const Kernel k = calibrate(s, h);
  double weight = 0, gradient = 0, gradient2 = 0;
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      for (int z = -3; z <= 3; ++z) {
        const double r = s * std::sqrt(x * x + y * y + z * z);
        weight += k.weight(static_cast<float>(r * r));
        if (r == 0) continue;
        const double e = k.slope(static_cast<float>(r));
        gradient += e * (z * s) * (z * s) / r;
        gradient2 += e * e;
      }
    }
  }
  EXPECT_NEAR(weight, 1, 2e-6);
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
    const float a = small.weight(x * small.h2), b = large.weight(x * large.h2);
    EXPECT_NEAR(a, b, 1e-5f * b);
    const float da = small.slope(x * small.h) * small.h, db = large.slope(x * large.h) * large.h;
    EXPECT_NEAR(da, db, 1e-5f * db);
  }
}

TEST_P(KernelTest, NothingIsFeltBeyondTheSupport) {
  const Kernel k = calibrate(0.05, GetParam() * 0.05);
  EXPECT_EQ(k.weight(k.h2), 0);
  EXPECT_EQ(k.weight(1e30f), 0);
  EXPECT_EQ(k.slope(k.h), 0);
  EXPECT_EQ(k.slope(1e15f), 0);
}

INSTANTIATE_TEST_SUITE_P(Ratios, KernelTest, testing::Values(1.5, 1.75, 2.0, 2.5, 3.0));

}  // namespace
}  // namespace meniscus::fluid
