// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The viscosity pass over particles that stand on their lattice.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pbd/math/vec.h"
#include "tests/devices.h"
#include "tests/unit/solver_bench.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.05f, support = 0.1f;
constexpr float pi = 3.14159265f;

class ViscosityTest : public OnDevice {
 protected:
  std::unique_ptr<SolverBench> bench_ = make_solver_bench(GetParam());

  static SmoothingCase lattice(int nx, int ny, int nz) {
    SmoothingCase c;
    c.support_radius = support;
    c.kernel = fluid::calibrate(spacing, support);
    c.materials = {fluid::Material{}};
    const float inverse_mass = 1 / (1000 * spacing * spacing * spacing);
    for (int k = 0; k < nz; ++k) {
      for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
          const Vec3 cell{float(i) - 0.5f * float(nx - 1), float(j) - 0.5f * float(ny - 1),
                          float(k) - 0.5f * float(nz - 1)};
          c.particles.push_back(pbd::with_w(spacing * cell, inverse_mass));
        }
      }
    }
    c.groups.assign(c.particles.size(), 0);
    c.velocities.assign(c.particles.size(), {0, 0, 0});
    return c;
  }

  /// v = cos(k y) along x, with antinodes at the free ends.
  static SmoothingCase shear_wave(float wave_number) {
    SmoothingCase c = lattice(16, 40, 16);
    for (size_t i = 0; i < c.particles.size(); ++i)
      c.velocities[i].x = std::cos(wave_number * c.particles[i].y);
    return c;
  }

  /// The wave's amplitude along the core, away from the sides.
  double amplitude(const SmoothingCase& c, float wave_number) const {
    const std::vector<Vec3> v = bench_->smooth(c);
    double along = 0, norm = 0;
    for (size_t i = 0; i < v.size(); ++i) {
      const Vec3 x = c.particles[i].xyz();
      if (std::fabs(x.x) > spacing || std::fabs(x.z) > spacing || std::fabs(x.y) > 10 * spacing) continue;
      const double wave = std::cos(wave_number * x.y);
      along += v[i].x * wave;
      norm += wave * wave;
    }
    return along / norm;
  }

  static Vec3 momentum(const SmoothingCase& c, std::span<const Vec3> velocities) {
    double sum[3] = {};
    for (size_t i = 0; i < velocities.size(); ++i) {
      sum[0] += velocities[i].x / c.particles[i].w;
      sum[1] += velocities[i].y / c.particles[i].w;
      sum[2] += velocities[i].z / c.particles[i].w;
    }
    return {float(sum[0]), float(sum[1]), float(sum[2])};
  }
};

TEST_P(ViscosityTest, AShearWaveDecaysAtTheAnalyticRate) {
  const float wave_number = 2 * pi / (20 * spacing), viscosity = 0.01f;
  SmoothingCase c = shear_wave(wave_number);
  c.materials[0].viscosity = viscosity;
  c.dt = 0.001f;
  c.passes = 800;
  const double time = double{c.dt} * c.passes;
  const double rate = -std::log(amplitude(c, wave_number)) / time;
  EXPECT_NEAR(rate / (viscosity * wave_number * wave_number), 1, 0.06);
}

TEST_P(ViscosityTest, XsphDoesNotDependOnTheStep) {
  const float wave_number = 2 * pi / (8 * spacing);
  SmoothingCase c = shear_wave(wave_number);
  c.materials[0].xsph = 5;
  c.dt = 0.005f;
  c.passes = 40;
  const double coarse = -std::log(amplitude(c, wave_number));
  c.dt = 0.0025f;
  c.passes = 80;
  const double fine = -std::log(amplitude(c, wave_number));
  EXPECT_GT(fine, 0.05);
  EXPECT_NEAR(coarse / fine, 1, 0.03);
}

TEST_P(ViscosityTest, ViscosityDoesNotDependOnTheSupport) {
  const float wave_number = 2 * pi / (40 * spacing);
  double rates[2];
  for (int k = 0; k < 2; ++k) {
    SmoothingCase c = shear_wave(wave_number);
    c.support_radius = (k ? 2.5f : 2.0f) * spacing;
    c.kernel = fluid::calibrate(spacing, c.support_radius);
    c.materials[0].viscosity = 0.01f;
    c.dt = 0.001f;
    c.passes = 300;
    rates[k] = -std::log(amplitude(c, wave_number));
  }
  EXPECT_NEAR(rates[1] / rates[0], 1, 0.08);  // the lattice's second moment is not quite the kernel's
}

TEST_P(ViscosityTest, AUniformMotionStaysAsItIs) {
  SmoothingCase c = lattice(8, 8, 8);
  c.materials[0].viscosity = 0.1f;
  c.materials[0].xsph = 20;
  c.velocities.assign(c.particles.size(), {1, -2, 3});
  c.passes = 20;
  for (Vec3 v : bench_->smooth(c)) EXPECT_EQ(v, (Vec3{1, -2, 3}));
}

TEST_P(ViscosityTest, TwoFluidsKeepTheirMomentum) {
  SmoothingCase c = lattice(10, 10, 10);
  c.materials = {{1000, 0.02f, 5, 0, 0, 0}, {100, 0, 30, 0, 0, 0}};
  std::mt19937 random(9);
  std::uniform_real_distribution<float> noise(-1, 1);
  double magnitude = 0;
  for (size_t i = 0; i < c.particles.size(); ++i) {
    c.groups[i] = static_cast<uint32_t>(random() % 2);
    if (c.groups[i]) c.particles[i].w *= 10;
    c.velocities[i] = {noise(random), noise(random), noise(random)};
    magnitude += length(c.velocities[i]) / c.particles[i].w;
  }
  const Vec3 before = momentum(c, c.velocities);
  c.passes = 100;
  const std::vector<Vec3> v = bench_->smooth(c);
  EXPECT_LT(length(momentum(c, v) - before) / magnitude, 1e-5);
  double after = 0, energy = 0;
  for (size_t i = 0; i < v.size(); ++i) {
    after += dot(v[i], v[i]) / c.particles[i].w;
    energy += dot(c.velocities[i], c.velocities[i]) / c.particles[i].w;
  }
  EXPECT_LT(after, 0.5 * energy);
}

TEST_P(ViscosityTest, AVeryStiffFluidDoesNotExplode) {
  SmoothingCase c = shear_wave(2 * pi / (8 * spacing));
  c.materials[0].viscosity = 1e4f;
  c.passes = 50;
  for (Vec3 v : bench_->smooth(c)) EXPECT_LT(length(v), 1.0001f);
}

MENISCUS_ON_EACH_DEVICE(ViscosityTest);

}  // namespace
}  // namespace meniscus::tests
