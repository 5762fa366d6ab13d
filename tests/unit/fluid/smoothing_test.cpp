// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// XSPH and vorticity confinement over particles on their rest lattice.
#include <array>
#include <random>

#include "tests/unit/fluid/block_test.h"

namespace meniscus::tests {
namespace {

using Double3 = std::array<double, 3>;

class SmoothingTest : public BlockTest {};

TEST_P(SmoothingTest, XsphDoesNotDependOnTheStep) {
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

TEST_P(SmoothingTest, AUniformMotionStaysAsItIs) {
  SmoothingCase c = lattice(8, 8, 8);
  c.materials[0].xsph = 20;
  c.velocities.assign(c.particles.size(), {1, -2, 3});
  c.passes = 20;
  for (Vec3 v : bench_->smooth(c)) EXPECT_EQ(v, (Vec3{1, -2, 3}));
}

TEST_P(SmoothingTest, TwoFluidsKeepTheirMomentum) {
  SmoothingCase c = lattice(10, 10, 10);
  c.materials = {{1000, 0, 5, 0, 0, 0}, {100, 0, 30, 0, 0, 0}};
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

/// Passes written down from their formulas: in double, over all pairs of one fluid.
class SmoothingReference {
 public:
  explicit SmoothingReference(const SmoothingCase& setup)
      : setup_(setup), curl_size_(setup.particles.size()) {
    for (Vec3 v : setup.velocities) velocities.push_back({v.x, v.y, v.z});
  }

  void pass() {
    const fluid::Material& m = setup_.materials[0];
    const double smoothing = -std::expm1(-double{m.xsph} * setup_.dt);
    std::vector<Double3> next = velocities;
    std::vector<double> next_size(curl_size_.size());
    for (size_t i = 0; i < velocities.size(); ++i) {
      Double3 curl{}, uphill{};
      for (size_t j = 0; j < velocities.size(); ++j) {
        const Vec3 d = setup_.particles[i].xyz() - setup_.particles[j].xyz();
        const double r = std::sqrt(double{d.x} * d.x + double{d.y} * d.y + double{d.z} * d.z);
        if (j == i || r >= setup_.kernel.h) continue;
        const Double3 relative = {velocities[j][0] - velocities[i][0], velocities[j][1] - velocities[i][1],
                                  velocities[j][2] - velocities[i][2]};
        const double apart = setup_.kernel.h - r, u = double{setup_.kernel.h2} - r * r;
        const double slope = std::fabs(setup_.kernel.peak_slope / setup_.kernel.h2) * apart * apart / r;
        const Double3 along = {slope * d.x, slope * d.y, slope * d.z};
        const Double3 turn = cross(relative, along);
        for (int k = 0; k < 3; ++k) {
          next[i][k] += smoothing * setup_.kernel.poly6 * u * u * u * relative[k];
          curl[k] += turn[k];
          uphill[k] += (curl_size_[i] - curl_size_[j]) * along[k];
        }
      }
      next_size[i] = norm(curl);
      if (norm(uphill) == 0) continue;
      const Double3 push = cross(uphill, curl);
      for (int k = 0; k < 3; ++k)
        next[i][k] += setup_.dt * m.vorticity_confinement * setup_.kernel.h * push[k] / norm(uphill);
    }
    velocities = next;
    curl_size_ = next_size;
  }

  std::vector<Double3> velocities;

 private:
  static Double3 cross(const Double3& a, const Double3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static double norm(const Double3& a) { return std::hypot(a[0], a[1], a[2]); }

  const SmoothingCase& setup_;
  std::vector<double> curl_size_;  // at the last pass
};

TEST_P(SmoothingTest, VorticityIsConfinedByItsFormulas) {
  SmoothingCase c = lattice(9, 8, 7);
  c.materials[0].xsph = 5;
  c.materials[0].vorticity_confinement = 0.5f;
  std::mt19937 random(4);
  std::uniform_real_distribution<float> noise(-1, 1);
  for (size_t i = 0; i < c.particles.size(); ++i) {
    const Vec3 shift{noise(random), noise(random), noise(random)};
    c.particles[i] = pbd::with_w(c.particles[i].xyz() + 0.2f * spacing * shift, c.particles[i].w);
    c.velocities[i] = {noise(random), noise(random), noise(random)};
  }
  SmoothingReference reference(c);
  for (int passes = 1; passes <= 3; ++passes) {
    c.passes = passes;
    reference.pass();
    const std::vector<Vec3> v = bench_->smooth(c);
    for (size_t i = 0; i < v.size(); ++i) {
      const Double3& wanted = reference.velocities[i];
      EXPECT_NEAR(v[i].x, wanted[0], 1e-4) << "particle " << i << ", pass " << passes;
      EXPECT_NEAR(v[i].y, wanted[1], 1e-4) << "particle " << i << ", pass " << passes;
      EXPECT_NEAR(v[i].z, wanted[2], 1e-4) << "particle " << i << ", pass " << passes;
    }
  }
}

/// A vortex turns on with confinement, where viscosity slows it without.
TEST_P(SmoothingTest, ConfinementKeepsAVortexTurning) {
  const auto energy_left = [&](float confinement) {
    SmoothingCase c = lattice(16, 16, 8);
    c.materials[0].xsph = 5;
    c.materials[0].vorticity_confinement = confinement;
    c.dt = 0.004f;
    double before = 0, after = 0;
    for (size_t i = 0; i < c.particles.size(); ++i) {
      const Vec3 x = c.particles[i].xyz();
      const float fall_off = std::exp(-(x.x * x.x + x.y * x.y) / (16 * spacing * spacing));
      c.velocities[i] = 5 * fall_off * Vec3{-x.y, x.x, 0};
      before += dot(c.velocities[i], c.velocities[i]);
    }
    c.passes = 100;
    for (Vec3 v : bench_->smooth(c)) after += dot(v, v);
    return after / before;
  };
  const double without = energy_left(0), with = energy_left(0.5f);
  EXPECT_LT(without, 0.9);
  EXPECT_GT(with, 1.1 * without);
  EXPECT_LT(with, 2);
}

MENISCUS_ON_EACH_DEVICE(SmoothingTest);

}  // namespace
}  // namespace meniscus::tests
