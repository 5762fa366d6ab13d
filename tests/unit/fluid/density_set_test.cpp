// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The density solve of each device against the slow reference of density_reference.h.
#include <gtest/gtest.h>

#include <random>

#include "tests/devices.h"
#include "tests/unit/fluid/density_reference.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.05f, support = 0.1f;

class DensityTest : public OnDevice {
 protected:
  std::unique_ptr<SolverBench> bench_ = make_solver_bench(GetParam());

  static collision::Shape plane(Vec3 normal, float offset) {
    collision::Shape s;
    s.size = normal;
    s.offset = offset;
    return s;
  }

  /// A squeezed and shaken lattice in the corner x, y, z > 0, of particles of two masses.
  static DensityCase shaken(float squeeze = 0.93f) {
    DensityCase c;
    c.support_radius = support;
    c.kernel = fluid::calibrate(spacing, support);
    c.parameters.chebyshev = false;
    c.parameters.warm_start = 0;
    c.parameters.correction_limit = 0.25f * spacing;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> noise(-0.2f, 0.2f);
    const float s = squeeze * spacing, mass = 1000 * spacing * spacing * spacing;
    for (int n = 0; n < 512; ++n) {
      const Vec3 cell{0.5f + float(n % 8), 0.5f + float(n / 8 % 8), 0.5f + float(n / 64)};
      const Vec3 moved{noise(random), noise(random), noise(random)};
      c.particles.push_back(pbd::with_w(s * (cell + moved), 1 / (n % 3 ? mass : 0.1f * mass)));
    }
    return c;
  }

  /// Σ max(C, 0) once the iterations are done.
  double error_after(const DensityCase& c) {
    DensityCase after = c;
    const DensitySolution found = bench_->solve_density(c);
    for (size_t i = 0; i < c.particles.size(); ++i) {
      after.particles[i] = pbd::with_w(found.positions[i], c.particles[i].w);
    }
    after.iterations = 1;
    double error = 0;
    for (float e : bench_->solve_density(after).errors) error += std::max(e, 0.0f);
    return error;
  }

  void expect_reference(const DensityCase& c) {
    DensityReference reference(c);
    std::vector<double> errors;
    for (size_t i = 0; i < c.particles.size(); ++i) errors.push_back(reference.error(i));
    for (int iteration = 0; iteration < c.iterations; ++iteration) reference.iterate();
    const DensitySolution found = bench_->solve_density(c);
    const double scale = *std::max_element(reference.multipliers.begin(), reference.multipliers.end());
    ASSERT_GT(scale, 0);
    for (size_t i = 0; i < c.particles.size(); ++i) {
      EXPECT_NEAR(found.errors[i], errors[i], 2e-6) << "C of particle " << i;
      EXPECT_NEAR(found.multipliers[i], reference.multipliers[i], 2e-5 * scale) << "λ of particle " << i;
      const Double3& x = reference.positions[i];
      EXPECT_NEAR(found.positions[i].x, x[0], 1e-5 * support) << "particle " << i;
      EXPECT_NEAR(found.positions[i].y, x[1], 1e-5 * support) << "particle " << i;
      EXPECT_NEAR(found.positions[i].z, x[2], 1e-5 * support) << "particle " << i;
    }
  }
};

TEST_P(DensityTest, OneIterationInTheOpen) {
  expect_reference(shaken());
}

TEST_P(DensityTest, MultipliersAddUpOverIterations) {
  DensityCase c = shaken();
  c.iterations = 4;
  expect_reference(c);
}

TEST_P(DensityTest, OneIterationOfACompressibleFluid) {
  DensityCase c = shaken();
  c.parameters.compressibility = 1e-4f;
  c.iterations = 3;
  expect_reference(c);
}

TEST_P(DensityTest, CorrectionsAreLimited) {
  DensityCase c = shaken(0.6f);
  c.parameters.correction_limit = 0.01f * spacing;
  expect_reference(c);
}

TEST_P(DensityTest, OneIterationAtAWall) {
  DensityCase c = shaken();
  c.planes = {plane({1, 0, 0}, -0.002f)};
  expect_reference(c);
}

TEST_P(DensityTest, OneIterationWithEachKernel) {
  for (SmoothingKernel kernel : {SmoothingKernel::wendland_c2, SmoothingKernel::cubic_spline}) {
    DensityCase c = shaken();
    c.kernel = fluid::calibrate(spacing, support, kernel);
    c.parameters.spectral_bound = c.kernel.spectral_bound;  // so that ω is the one that is asked for
    expect_reference(c);
    c.planes = {plane({1, 0, 0}, -0.002f), plane({0, 1, 0}, 0)};
    c.parameters.compressibility = 1e-4f;
    expect_reference(c);
  }
}

TEST_P(DensityTest, OneIterationAtASlopingWall) {
  DensityCase c = shaken();
  const Vec3 normal = normalized_or({1, 2, -0.5f}, {0, 1, 0});
  float offset = 1e9f;
  for (const pbd::Vec4& p : c.particles) offset = std::min(offset, dot(normal, p.xyz()) - 0.003f);
  c.planes = {plane(normal, offset)};
  expect_reference(c);
}

TEST_P(DensityTest, OneIterationInAnEdge) {
  DensityCase c = shaken();
  c.planes = {plane({1, 0, 0}, -0.002f), plane({0, 1, 0}, 0)};
  expect_reference(c);
}

TEST_P(DensityTest, OneIterationInACorner) {
  DensityCase c = shaken();
  c.planes = {plane({1, 0, 0}, 0), plane({0, 1, 0}, 0.001f), plane({0, 0, 1}, -0.001f)};
  c.iterations = 2;
  expect_reference(c);
}

// A pressure moves a particle by what grows with the square of the step.
TEST_P(DensityTest, AStartFromALongerStepIsScaledWithTheSquareOfTheStep) {
  DensityCase c = shaken();
  const auto pushed_by = [&](float last_dt) {
    const std::vector<Vec3> pushed = bench_->push(c, 1e-7f, last_dt);
    double sum = 0;
    for (size_t i = 0; i < pushed.size(); ++i) sum += double{length(pushed[i] - c.particles[i].xyz())};
    return sum;
  };
  const double same = pushed_by(c.dt);
  ASSERT_GT(same, 512 * 1e-4 * double{spacing});
  EXPECT_NEAR(pushed_by(2 * c.dt) / same, 0.25, 0.0025);
  EXPECT_NEAR(pushed_by(4 * c.dt) / same, 0.0625, 0.00125);
  EXPECT_NEAR(pushed_by(0.5f * c.dt) / same, 1, 1e-6) << "a shorter step's multipliers are not raised";
}

// What the fluid pushes, the walls give back: under a constant pressure nothing moves.
TEST_P(DensityTest, AConstantMultiplierPushesNoParticleAtAWall) {
  DensityCase c = shaken();
  const float mass = 1000 * spacing * spacing * spacing, s = 0.97f * spacing, side = 8 * s;
  for (int n = 0; n < 512; ++n) {
    const Vec3 cell{0.5f + float(n % 8), 0.5f + float(n / 8 % 8), 0.5f + float(n / 64)};
    c.particles[static_cast<size_t>(n)] = pbd::with_w(s * cell, 1 / mass);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 n{axis == 0 ? 1.0f : 0, axis == 1 ? 1.0f : 0, axis == 2 ? 1.0f : 0};
    c.planes.push_back(plane(n, 0));
    c.planes.push_back(plane(-n, -side));
  }
  const std::vector<Vec3> pushed = bench_->push(c, 1e-6f, c.dt);
  for (size_t i = 0; i < c.particles.size(); ++i) {
    EXPECT_LT(length(pushed[i] - c.particles[i].xyz()), 1e-5f * spacing) << "particle " << i;
  }
  c.planes.pop_back();  // without one wall its layer goes, and by much
  EXPECT_GT(length(bench_->push(c, 1e-6f, c.dt)[511] - c.particles[511].xyz()), 1e-3f * spacing);
}

TEST_P(DensityTest, InTheOpenNoMomentumIsMade) {
  for (bool chebyshev : {false, true}) {
    DensityCase c = shaken();
    c.parameters.chebyshev = chebyshev;
    c.iterations = 10;
    const DensitySolution found = bench_->solve_density(c);
    double sum[3] = {}, magnitude = 0;
    for (size_t i = 0; i < c.particles.size(); ++i) {
      const Vec3 moved = found.positions[i] - c.particles[i].xyz();
      const double mass = 1.0 / c.particles[i].w;
      sum[0] += mass * moved.x;
      sum[1] += mass * moved.y;
      sum[2] += mass * moved.z;
      magnitude += mass * length(moved);
    }
    for (double s : sum) EXPECT_NEAR(s / magnitude, 0, 1e-5);
  }
}

TEST_P(DensityTest, IterationsBringTheErrorDown) {
  double at_ten[2];
  for (bool chebyshev : {false, true}) {
    DensityCase c = shaken(0.99f);
    c.parameters.chebyshev = chebyshev;
    c.planes = {plane({1, 0, 0}, 0), plane({0, 1, 0}, 0), plane({0, 0, 1}, 0)};
    double last = 1e9;
    for (int iterations : {1, 3, 10}) {
      c.iterations = iterations;
      const double error = error_after(c);
      EXPECT_LT(error, 0.8 * last) << iterations << " iterations, chebyshev " << chebyshev;
      last = error;
    }
    at_ten[chebyshev] = last;
  }
  EXPECT_LT(at_ten[1], 0.5 * at_ten[0]);
}

MENISCUS_ON_EACH_DEVICE(DensityTest);

}  // namespace
}  // namespace meniscus::tests
