// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A substep of each baseline on each device against the slow reference of baseline_reference.h.
#include <gtest/gtest.h>

#include <random>

#include "tests/devices.h"
#include "tests/unit/fluid/baselines/baseline_reference.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.05f, support = 0.1f;

class BaselineTest : public OnDevice {
 protected:
  std::unique_ptr<SolverBench> bench_ = make_solver_bench(GetParam());

  /// A squeezed and shaken lattice in the corner x, y, z > 0, of particles of two masses that move at random.
  static DensityCase shaken(fluid::DensityMethod method) {
    DensityCase c;
    c.support_radius = support;
    c.kernel = fluid::calibrate(spacing, support);
    c.parameters.method = method;
    c.parameters.compressibility = method == fluid::DensityMethod::wcsph ? 1e-6f : 0.0f;
    c.iterations = 3;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> noise(-0.2f, 0.2f);
    const float s = 0.96f * spacing, mass = 1000 * spacing * spacing * spacing;
    for (int n = 0; n < 512; ++n) {
      const Vec3 cell{0.5f + float(n % 8), 0.5f + float(n / 8 % 8), 0.5f + float(n / 64)};
      const Vec3 moved{noise(random), noise(random), noise(random)};
      c.particles.push_back(pbd::with_w(s * (cell + moved), 1 / (n % 3 ? mass : 0.1f * mass)));
      c.velocities.push_back({noise(random), noise(random), noise(random)});
    }
    return c;
  }

  static collision::Shape plane(Vec3 normal, float offset) {
    collision::Shape s;
    s.size = normal;
    s.offset = offset;
    return s;
  }

  static void add_corner(DensityCase& c) {
    c.planes = {plane({1, 0, 0}, 0), plane({0, 1, 0}, 0.001f), plane({0, 0, 1}, -0.001f)};
  }

  void expect_reference(const DensityCase& c) {
    BaselineReference reference(c);
    reference.solve();
    const DensitySolution found = bench_->solve_baseline(c);
    const double scale = *std::max_element(reference.multipliers.begin(), reference.multipliers.end());
    double fastest = 0;
    for (const Double3& v : reference.velocities) fastest = std::max({fastest, v[0], v[1], v[2]});
    ASSERT_GT(scale, 0);
    for (size_t i = 0; i < c.particles.size(); ++i) {
      EXPECT_NEAR(found.multipliers[i], reference.multipliers[i], 1e-4 * scale) << "Λ of particle " << i;
      const Double3 &x = reference.positions[i], &v = reference.velocities[i];
      EXPECT_NEAR(found.positions[i].x, x[0], 1e-5 * support) << "particle " << i;
      EXPECT_NEAR(found.positions[i].y, x[1], 1e-5 * support) << "particle " << i;
      EXPECT_NEAR(found.positions[i].z, x[2], 1e-5 * support) << "particle " << i;
      EXPECT_NEAR(found.velocities[i].x, v[0], 1e-4 * fastest) << "particle " << i;
      EXPECT_NEAR(found.velocities[i].y, v[1], 1e-4 * fastest) << "particle " << i;
      EXPECT_NEAR(found.velocities[i].z, v[2], 1e-4 * fastest) << "particle " << i;
    }
  }

  void expect_reference_of(fluid::DensityMethod method) {
    DensityCase c = shaken(method);
    expect_reference(c);
    add_corner(c);
    expect_reference(c);
  }
};

TEST_P(BaselineTest, PcisphIsTheReference) {
  expect_reference_of(fluid::DensityMethod::pcisph);
}

TEST_P(BaselineTest, WcsphIsTheReference) {
  expect_reference_of(fluid::DensityMethod::wcsph);
}

TEST_P(BaselineTest, DfsphIsTheReference) {
  expect_reference_of(fluid::DensityMethod::dfsph);
}

MENISCUS_ON_EACH_DEVICE(BaselineTest);

}  // namespace
}  // namespace meniscus::tests
