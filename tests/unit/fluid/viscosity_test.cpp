// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The solve of viscosity over particles that stand still.
#include <array>
#include <random>

#include "tests/unit/fluid/block_test.h"

namespace meniscus::tests {
namespace {

class ViscosityTest : public BlockTest {
 protected:
  static void disturb(SmoothingCase& c, float by) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> noise(-by * spacing, by * spacing);
    for (pbd::Vec4& p : c.particles)
      p = pbd::with_w(p.xyz() + Vec3{noise(random), noise(random), noise(random)}, p.w);
  }

  /// Of the wave's decay, over ν k².
  double decay(SmoothingCase c, float wave_number) const {
    c.materials[0].dynamic_viscosity = 10;
    c.dt = 0.005f;
    c.passes = 40;
    const double before = amplitude_of(c.velocities, c, wave_number);
    const double rate = -std::log(amplitude(c, wave_number) / before) / (double{c.dt} * c.passes);
    return rate / (0.01 * wave_number * wave_number);
  }

  /// kg m²/s about the origin.
  static Vec3 spin(const SmoothingCase& c, std::span<const Vec3> velocities) {
    double sum[3] = {};
    for (size_t i = 0; i < velocities.size(); ++i) {
      const Vec3 l = (1 / c.particles[i].w) * cross(c.particles[i].xyz(), velocities[i]);
      sum[0] += l.x;
      sum[1] += l.y;
      sum[2] += l.z;
    }
    return {float(sum[0]), float(sum[1]), float(sum[2])};
  }

  /// A block that rests on the plane y = 0, long along x.
  static SmoothingCase film(int layers, float slip_length) {
    SmoothingCase c = lattice(48, layers, 6);
    for (pbd::Vec4& p : c.particles) p.y += 0.5f * static_cast<float>(layers) * spacing;
    collision::Shape floor;
    floor.surface.slip_length = slip_length;
    c.planes = {floor};
    return c;
  }
};

TEST_P(ViscosityTest, AShearWaveDecaysAtTheAnalyticRate) {
  const float wave_number = 2 * pi / (20 * spacing);
  SmoothingCase c = shear_wave(wave_number);
  EXPECT_NEAR(decay(c, wave_number), 1, 0.03);
  disturb(c, 0.3f);  // pairs that are nearly parted give way
  EXPECT_NEAR(decay(c, wave_number), 1, 0.11);
}

TEST_P(ViscosityTest, DoesNotDependOnTheSupport) {
  const float wave_number = 2 * pi / (40 * spacing);
  double rates[2];
  for (int k = 0; k < 2; ++k) {
    SmoothingCase c = shear_wave(wave_number);
    c.support_radius = (k ? 2.5f : 2.0f) * spacing;
    c.kernel = fluid::calibrate(spacing, c.support_radius);
    rates[k] = decay(c, wave_number);
  }
  EXPECT_NEAR(rates[1] / rates[0], 1, 0.03);
}

TEST_P(ViscosityTest, ARigidMotionStaysAsItIs) {
  SmoothingCase c = lattice(8, 8, 8);
  disturb(c, 0.3f);
  c.materials[0].dynamic_viscosity = 1000;
  c.velocities.assign(c.particles.size(), {1, -2, 3});
  c.passes = 20;
  for (Vec3 v : bench_->smooth(c)) EXPECT_EQ(v, (Vec3{1, -2, 3}));
  const Vec3 turn{0.5f, 1, -0.7f};
  for (size_t i = 0; i < c.velocities.size(); ++i)
    c.velocities[i] = Vec3{1, -2, 3} + cross(turn, c.particles[i].xyz());
  const std::vector<Vec3> v = bench_->smooth(c);
  for (size_t i = 0; i < v.size(); ++i) EXPECT_LT(length(v[i] - c.velocities[i]), 1e-5f);
}

TEST_P(ViscosityTest, TwoFluidsKeepTheirMomenta) {
  for (const float viscosity : {1.0f, 1000.0f}) {
    SmoothingCase c = lattice(10, 10, 10);
    disturb(c, 0.3f);
    c.materials = {{1000, viscosity, 0, 0, 0, 0}, {100, 0.1f * viscosity, 0, 0, 0, 0}};
    std::mt19937 random(9);
    std::uniform_real_distribution<float> noise(-1, 1);
    double magnitude = 0, energy = 0, after = 0;
    for (size_t i = 0; i < c.particles.size(); ++i) {
      c.groups[i] = static_cast<uint32_t>(random() % 2);
      if (c.groups[i]) c.particles[i].w *= 10;
      c.velocities[i] = {noise(random), noise(random), noise(random)};
      magnitude += length(c.velocities[i]) / c.particles[i].w;
      energy += dot(c.velocities[i], c.velocities[i]) / c.particles[i].w;
    }
    c.passes = 20;
    const std::vector<Vec3> v = bench_->smooth(c);
    EXPECT_LT(length(momentum(c, v) - momentum(c, c.velocities)) / magnitude, 1e-6);
    EXPECT_LT(length(spin(c, v) - spin(c, c.velocities)) / (5 * spacing * magnitude), 1e-6);
    for (size_t i = 0; i < v.size(); ++i) after += dot(v[i], v[i]) / c.particles[i].w;
    EXPECT_LT(after, 0.99 * energy);
  }
}

/// The equation in double, over all pairs.
TEST_P(ViscosityTest, SolvesItsEquation) {
  SmoothingCase c = lattice(9, 8, 7);
  disturb(c, 0.3f);
  c.materials = {{1000, 300, 0, 0, 0, 0}, {500, 20, 0, 0, 0, 0}};
  std::mt19937 random(11);
  std::uniform_real_distribution<float> noise(-1, 1);
  for (size_t i = 0; i < c.particles.size(); ++i) {
    c.groups[i] = static_cast<uint32_t>(i % 3 == 0);
    if (c.groups[i]) c.particles[i].w *= 2;
    c.velocities[i] = {noise(random), noise(random), noise(random)};
  }
  double shear = 0;  // Σ (1 − r²/h²)² x² y²/r² over the rest lattice
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      for (int k = -2; k <= 2; ++k) {
        const double r2 = i * i + j * j + k * k, u = std::max(0.0, 1 - r2 / 4);
        if (r2 > 0) shear += u * u * (i * i) * (j * j) / r2 * spacing * spacing;
      }
  const std::vector<Vec3> v = bench_->smooth(c);
  double worst = 0;  // m/s
  for (size_t i = 0; i < v.size(); ++i) {
    std::array<double, 3> force{};
    for (size_t j = 0; j < v.size(); ++j) {
      const Vec3 d = c.particles[i].xyz() - c.particles[j].xyz();
      const double r2 = dot(d, d), u = 1 - r2 / (support * support);
      if (j == i || u <= 0) continue;
      const double a = c.materials[c.groups[i]].dynamic_viscosity,
                   b = c.materials[c.groups[j]].dynamic_viscosity;
      const double volume = spacing * spacing * spacing;
      const double along = 10 * 2 * a * b / (a + b) * volume / (5 * shear) * u * u * dot(v[i] - v[j], d) / r2;
      force[0] += along * d.x;
      force[1] += along * d.y;
      force[2] += along * d.z;
    }
    const Vec3 change = v[i] - c.velocities[i];
    const double push = double{c.dt} * c.particles[i].w;
    worst = std::max({worst, std::fabs(change.x + push * force[0]), std::fabs(change.y + push * force[1]),
                      std::fabs(change.z + push * force[2])});
  }
  EXPECT_LT(worst, 1e-3);
}

TEST_P(ViscosityTest, AVeryStiffFluidDoesNotExplode) {
  SmoothingCase c = shear_wave(2 * pi / (8 * spacing));
  double before = 0, after = 0;
  for (Vec3 v : c.velocities) before += dot(v, v);
  c.materials[0].dynamic_viscosity = 1e6f;
  c.passes = 3;
  for (Vec3 v : bench_->smooth(c)) after += dot(v, v);
  EXPECT_LT(after, before);
}

/// The slowest motion of a film over a wall is cos(k (H − y)) with k tan(k H) = 1/slip length.
TEST_P(ViscosityTest, AFilmSlowsDownOverItsWall) {
  constexpr int layers = 8;
  const float height = layers * spacing;
  const std::array<std::array<float, 2>, 3> cases{{{0, pi / 2}, {0.4f, 0.86033f}, {4, 0.31105f}}};
  for (const auto& [slip_length, root] : cases) {
    SmoothingCase c = film(layers, slip_length);
    disturb(c, 0.1f);
    c.materials[0].dynamic_viscosity = 100;
    for (size_t i = 0; i < c.particles.size(); ++i)
      c.velocities[i].x = std::cos(root / height * (height - c.particles[i].y));
    c.dt = 0.005f;
    c.passes = 60;
    const std::vector<Vec3> v = bench_->smooth(c);
    double along = 0, norm = 0;
    for (size_t i = 0; i < v.size(); ++i) {
      if (std::fabs(c.particles[i].x) > 4 * spacing) continue;
      along += double{v[i].x} * c.velocities[i].x;
      norm += double{c.velocities[i].x} * c.velocities[i].x;
    }
    const double rate = -std::log(along / norm) / (c.dt * c.passes), k = root / height;
    EXPECT_NEAR(rate / (0.1 * k * k), 1, 0.1) << "slip length " << slip_length;
  }
}

/// A linear shear leaves little force at a wall, wherever the first layer is. The integral over the
/// half-space alone would leave .18 and .35 of the stress.
TEST_P(ViscosityTest, AWallCompletesTheShearOfItsParticles) {
  constexpr float rate = 2, viscosity = 100;
  for (const float slip_length : {0.0f, 0.3f}) {
    for (const float lifted : {0.0f, 0.1f, 0.2f}) {
      SmoothingCase c = film(8, slip_length);
      for (pbd::Vec4& p : c.particles) p.y += lifted * spacing;
      c.materials[0].dynamic_viscosity = viscosity;
      for (size_t i = 0; i < c.particles.size(); ++i)
        c.velocities[i].x = rate * (c.particles[i].y + slip_length);
      c.dt = 1e-4f;
      const std::vector<Vec3> v = bench_->smooth(c);
      double force = 0;
      for (size_t i = 0; i < v.size(); ++i) {
        const pbd::Vec4& p = c.particles[i];
        if (std::fabs(p.x) < 8 * spacing && p.y < spacing + lifted * spacing)
          force += double{v[i].x - c.velocities[i].x} / double{p.w} / double{c.dt};
      }
      const double area = 16 * spacing * 6 * spacing;
      EXPECT_NEAR(force / (viscosity * rate * area), 0, 0.08) << slip_length << " m, lifted by " << lifted;
    }
  }
}

TEST_P(ViscosityTest, AFreeWallDoesNotBrake) {
  SmoothingCase c = film(6, std::numeric_limits<float>::infinity());
  c.materials[0].dynamic_viscosity = 100;
  c.velocities.assign(c.particles.size(), {1, 0, 0});
  c.passes = 20;
  for (Vec3 v : bench_->smooth(c)) EXPECT_EQ(v, (Vec3{1, 0, 0}));
}

MENISCUS_ON_EACH_DEVICE(ViscosityTest);

}  // namespace
}  // namespace meniscus::tests
