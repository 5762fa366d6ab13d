// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the smoothing kernels against their integrals.
#include "fluid/kernel/packing.h"

#include <gtest/gtest.h>

#include <algorithm>
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
double weight(const Kernel& kernel, double r) {
  const float t = static_cast<float>(r * r) * kernel.inverse_h2 + tiny_ratio2;
  return with_shape(kernel,
                    [&](const auto& k) { return k.peak_weight * k.weight_shape(t, 1 / std::sqrt(t)); });
}
double slope(const Kernel& kernel, double r) {
  const float t = static_cast<float>(r * r) * kernel.inverse_h2 + tiny_ratio2;
  return with_shape(kernel, [&](const auto& k) { return k.peak_slope * k.slope_shape(t, 1 / std::sqrt(t)); });
}

constexpr SmoothingKernel all_kernels[] = {SmoothingKernel::poly6_spiky, SmoothingKernel::wendland_c2,
                                           SmoothingKernel::cubic_spline};

class KernelTest : public testing::TestWithParam<double> {  // the ratio of support radius to spacing
 protected:
  static constexpr double s = 0.05;
  double h() const { return GetParam() * s; }

  /// Runs the test of each kernel, and says which one failed.
  template <class Test>
  void for_each_kernel(const Test& test) {
    for (SmoothingKernel shape : all_kernels) {
      SCOPED_TRACE(static_cast<int>(shape));
      test(calibrate(s, h(), shape), ExactKernel{shape, h()});
    }
  }
};

TEST_P(KernelTest, TheWeightIntegratesToOne) {
  for_each_kernel([&](const Kernel& k, const ExactKernel&) {
    EXPECT_NEAR(integrate(h(), [&](double r) { return weight(k, r); }) / k.volume, 1, 1e-4);
  });
}

TEST_P(KernelTest, TheMomentsAreThoseOfTheWeight) {
  for_each_kernel([&](const Kernel& k, const ExactKernel& exact) {
    const KernelMoments moments = moments_of(k.shape);
    const double second = integrate(h(), [&](double r) { return exact.weight(r) * r * r; });
    const double edge = integrate(h(), [&](double r) { return exact.weight(r) / (2 * r); });  // ∫ W 2πr dr
    EXPECT_NEAR(second / (h() * h()) / moments.second, 1, 1e-4);
    EXPECT_NEAR(edge * h() / moments.edge, 1, 1e-4);
  });
}

TEST_P(KernelTest, TheShapesAreThoseOfTheFormulas) {
  for_each_kernel([&](const Kernel& k, const ExactKernel& exact) {
    const double scale = k.greatest_slope, peak = weight(k, 0) / exact.weight(0);
    double greatest = 0;
    for (double x = 0.001; x < 1; x += 0.001) greatest = std::max(greatest, exact.slope(x * h()));
    if (k.shape == SmoothingKernel::poly6_spiky) greatest = exact.slope(0);
    for (double x = 0.05; x < 1; x += 0.05) {
      EXPECT_NEAR(weight(k, x * h()), peak * exact.weight(x * h()), 2e-6 * weight(k, 0));
      EXPECT_NEAR(slope(k, x * h()) / scale, exact.slope(x * h()) / greatest, 2e-5);
    }
  });
}

TEST_P(KernelTest, ByShapeOrByDistanceTheWeightIsTheSame) {
  for_each_kernel([&](const Kernel& kernel, const ExactKernel&) {
    with_shape(kernel, [&](const auto& k) {
      for (double x = 0; x < 1; x += 0.05) {
        const double r = x * k.h;
        EXPECT_NEAR(weight(k, r), k.weight(static_cast<float>(r * r)), 1e-5 * k.peak_weight);
      }
    });
  });
}

TEST_P(KernelTest, ThePullIsTheSlopeTimesAUnitVector) {
  for_each_kernel([&](const Kernel& kernel, const ExactKernel&) {
    with_shape(kernel, [&](const auto& k) {
      const pbd::Vec3Of<float> d{0.3f * k.h, -0.2f * k.h, 0.5f * k.h};
      const float t = k.distance_ratio2(d), inverse_root = 1 / std::sqrt(t);
      EXPECT_NEAR(t, 0.38, 1e-6);
      const float pull = k.peak_pull * k.slope_shape(t, inverse_root) * inverse_root * d.x;
      const double expected = slope(k, std::sqrt(0.38) * k.h) * 0.3 / std::sqrt(0.38);
      EXPECT_NEAR(pull, expected, 1e-5 * expected);
    });
  });
}

// |∇W| integrated against r/3 gives back the kernel's integral. Of spiky, too.
TEST_P(KernelTest, TheSlopeIntegratesToOne) {
  for_each_kernel([&](const Kernel&, const ExactKernel& exact) {
    EXPECT_NEAR(integrate(h(), [&](double r) { return r / 3 * exact.slope(r); }), 1, 1e-4);
  });
}

TEST_P(KernelTest, TheSlopeIsTheFiniteDifferenceOfTheWeight) {
  for_each_kernel([&](const Kernel& k, const ExactKernel& exact) {
    const auto of = [&](double r) {
      const bool is_spiky = k.shape == SmoothingKernel::poly6_spiky;
      return is_spiky ? 15 / (std::numbers::pi * std::pow(h(), 6)) * std::pow(h() - r, 3) : exact.weight(r);
    };
    for (double x = 0.05; x < 0.95; x += 0.1) {
      const double r = x * h(), dr = 1e-5 * h();
      const double difference = (of(r - dr) - of(r + dr)) / (2 * dr);
      EXPECT_NEAR(exact.slope(r), difference, 1e-5 * difference);
    }
  });
}

// Of weight_slope(), which surface tension takes.
TEST_P(KernelTest, TheWeightSlopeIsTheFiniteDifferenceOfTheWeight) {
  for_each_kernel([&](const Kernel& kernel, const ExactKernel& exact) {
    with_shape(kernel, [&](const auto& k) {
      for (double x = 0.05; x < 0.95; x += 0.1) {
        const double r = x * h(), dr = 1e-5 * h();
        const double difference = (exact.weight(r + dr) - exact.weight(r - dr)) / (2 * dr);
        EXPECT_NEAR(double{k.weight_slope(static_cast<float>(r * r))} * r, k.slope_volume * difference,
                    2e-5 * k.slope_volume * std::fabs(difference) + 1e-6 * k.peak_weight / k.h);
      }
    });
  });
}

TEST_P(KernelTest, OnTheRestLatticeTheWeightsOfPoly6AddUpToOneAndTheGradientIsExact) {
  const Kernel k = calibrate(s, h());
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

TEST_P(KernelTest, OnARelaxedPackingTheWeightsAddUpToOneAndPressureIsExact) {
  for_each_kernel([&](const Kernel& k, const ExactKernel&) {
    if (k.shape == SmoothingKernel::poly6_spiky) return;
    const ExactKernel in_spacings{k.shape, GetParam()};
    const Packing packing = relaxed_packing(in_spacings);
    const PackingSums sums = sum_over(packing, in_spacings);
    const double s3 = s * s * s;
    EXPECT_NEAR(k.volume / s3 * sums.weight, 1, 1e-5);
    EXPECT_NEAR(k.particle_volume / s3, 1, 1e-6);
    EXPECT_NEAR(k.slope_volume / s3 * sums.gradient, 1, 1e-5);
  });
}

// So mass, rest density and level are the same before and after a lattice has melted.
TEST_P(KernelTest, ALatticeIsAsDenseAsARelaxedPacking) {
  for_each_kernel([&](const Kernel& k, const ExactKernel& exact) {
    if (k.shape == SmoothingKernel::poly6_spiky || GetParam() < 2) return;
    const ExactKernel in_spacings{k.shape, GetParam()};
    const double on_lattice = sum_over(cubic_lattice(GetParam()), in_spacings).weight;
    // With a wide support the cubic spline forms pairs, and the packing becomes a little looser.
    const bool pairs = k.shape == SmoothingKernel::cubic_spline && GetParam() > 2.5;
    EXPECT_NEAR(on_lattice * k.volume / (s * s * s), 1, pairs ? 0.006 : 0.005);
    EXPECT_GT(exact.weight(0), 0);
  });
}

TEST_P(KernelTest, TheSpectrumIsBounded) {
  for_each_kernel([&](const Kernel& k, const ExactKernel&) {
    if (k.shape == SmoothingKernel::poly6_spiky) return;
    const double radius = spectral_radius(cubic_lattice(GetParam()), {k.shape, GetParam()});
    EXPECT_GT(k.spectral_bound, 1.3 * radius);
    EXPECT_LT(k.spectral_bound, 2.6 * radius);
  });
}

TEST_P(KernelTest, TheVolumeIsNearlyTheCubeOfTheSpacing) {
  for_each_kernel(
      [&](const Kernel& k, const ExactKernel&) { EXPECT_NEAR(k.volume / std::pow(s, 3), 1, 0.25); });
}

TEST_P(KernelTest, AScaledPackingHasTheSameKernel) {
  for (SmoothingKernel shape : all_kernels) {
    const Kernel small = calibrate(1e-3, GetParam() * 1e-3, shape),
                 large = calibrate(10, GetParam() * 10, shape);
    for (float x = 0; x < 1; x += 0.1f) {
      const double a = weight(small, x * small.h), b = weight(large, x * large.h);
      EXPECT_NEAR(a, b, 1e-5 * b + 1e-7);
      if (x == 0) continue;
      const double da = slope(small, x * small.h) * small.h, db = slope(large, x * large.h) * large.h;
      EXPECT_NEAR(da, db, 1e-5 * db + 1e-7);
    }
  }
}

TEST_P(KernelTest, NothingIsFeltBeyondTheSupport) {
  for_each_kernel([&](const Kernel& kernel, const ExactKernel&) {
    with_shape(kernel, [](const auto& k) {
      EXPECT_LE(k.weight(k.h2), 1e-20f);
      EXPECT_EQ(k.weight(1e30f), 0);
      for (float t : {1.0f, 1.5f, 1e32f}) {
        EXPECT_EQ(k.weight_shape(t, 1 / std::sqrt(t)), 0);
        EXPECT_EQ(k.slope_shape(t, 1 / std::sqrt(t)), 0);
      }
    });
  });
}

INSTANTIATE_TEST_SUITE_P(Ratios, KernelTest, testing::Values(1.5, 1.75, 2.0, 2.5, 3.0));

}  // namespace
}  // namespace meniscus::fluid
