// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rods against the elastica, Euler and Bernoulli's beam, and Michell's ring, over resolutions and substeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pbd/math/vec.h"
#include "tests/bench/harness/rod_bench.h"
#include "tests/devices.h"

namespace meniscus::tests {

namespace {

constexpr double pi = std::numbers::pi;

class RodValidation : public OnDevice {
 protected:
  std::unique_ptr<RodBench> bench(const RodScene& scene) { return make_rod_bench(GetParam(), scene); }

  float drop(float load, uint32_t segments, int substeps) {
    const auto rods = bench(cantilever(load, segments, substeps));
    clamp_first(*rods);
    rods->settle(500, 0.96f);
    return -rods->positions().back().y;
  }
};

// A cantilever of weight w a metre with B = wL³/EI, by integrating EI θ'' = −w (L − s) cos θ.
TEST_P(RodValidation, HeavyElasticaDropsAsItShould) {
  struct Case {
    float load, drop;
  };
  for (const Case c : {Case{1, 0.1235f}, Case{2, 0.2385f}, Case{10, 0.7002f}, Case{20, 0.8299f}}) {
    for (uint32_t segments : {20u, 40u}) {
      const float first = drop(c.load, segments, 5);
      EXPECT_NEAR(first, c.drop, 0.05f * c.drop) << "B = " << c.load << ", " << segments << " segments";
      for (int substeps : {10, 20, 40}) {
        EXPECT_NEAR(drop(c.load, segments, substeps), first, 0.01f * first)
            << "B = " << c.load << ", " << segments << " segments, " << substeps << " substeps";
      }
    }
  }
}

// ---- oscillation ----

/// The tip's crossings of rest upwards, s, and its largest height between them, m.
struct Swing {
  std::vector<double> crossings, heights;

  double frequency() const {
    return (static_cast<double>(crossings.size()) - 1) / (crossings.back() - crossings.front());
  }
};

constexpr double first_root = 1.875104;  // of cos x cosh x = −1

/// Starts a cantilever in its first mode, and follows its tip.
Swing swing(RodBench& bench, uint32_t segments, double frequency, size_t periods) {
  std::vector<Vec3> v(segments + 2, Vec3{0, 0, 0});
  for (uint32_t i = 1; i <= segments; ++i) {
    const double x = first_root * i / segments;
    const double shape = std::cosh(x) - std::cos(x) - 0.734096 * (std::sinh(x) - std::sin(x));
    v[i + 1].y = static_cast<float>(0.01 * 2 * pi * frequency * shape);
  }
  bench.set_velocities(v);
  Swing swing;
  const double dt = 1.0 / 60;
  double before = 0, highest = 0;
  for (int k = 1; swing.crossings.size() < periods && k < 6000; ++k) {
    bench.run(1);
    const double y = bench.positions().back().y;
    highest = std::max(highest, y);
    if (before < 0 && y >= 0) {
      swing.crossings.push_back((k - y / (y - before)) * dt);
      swing.heights.push_back(highest);
      highest = 0;
    }
    before = y;
  }
  return swing;
}

struct Cantilever {
  RodScene scene;
  double frequency;  ///< Hz, of the first mode: 3.516 √(EI/(ρAL⁴))/2π

  Cantilever(uint32_t segments, float radius, float youngs_modulus, float damping) {
    cloth::RodParameters p;
    p.radius = radius;
    p.youngs_modulus = youngs_modulus;
    p.shear_modulus = youngs_modulus / 2.6f;
    p.damping = damping;
    const float l = 1 / static_cast<float>(segments);
    scene.add(straight({-l, 0, 0}, {1, 0, 0}, segments + 1), p);
    scene.hold(0);
    scene.hold(1);
    scene.gravity = {0, 0, 0};
    scene.substeps = 20;
    frequency = first_root * first_root / (2 * pi) *
                std::sqrt(youngs_modulus * radius * radius / (4 * double{p.density}));
  }
};

TEST_P(RodValidation, CantileverSwingsAtItsFrequency) {
  struct Case {
    float radius, youngs_modulus;
  };
  for (const Case c : {Case{0.005f, 1e8f}, Case{0.001f, 2e11f}}) {
    for (uint32_t segments : {20u, 40u}) {
      const Cantilever beam(segments, c.radius, c.youngs_modulus, 0);
      const auto rods = bench(beam.scene);
      clamp_first(*rods);
      const Swing s = swing(*rods, segments, beam.frequency, 8);
      ASSERT_EQ(s.crossings.size(), 8u);
      EXPECT_NEAR(s.frequency(), beam.frequency, 0.01 * beam.frequency) << segments << " segments";
    }
  }
}

// Rayleigh's damping τ takes a mode's amplitude to e^(−τω²t/2) of it. Implicit integration adds the substep
// to τ.
TEST_P(RodValidation, DampingTakesWhatItSays) {
  const uint32_t segments = 20;
  const float damping = 0.02f;
  const Cantilever beam(segments, 0.005f, 2e8f, damping);
  const auto rods = bench(beam.scene);
  clamp_first(*rods);
  const Swing s = swing(*rods, segments, beam.frequency, 8);
  ASSERT_EQ(s.crossings.size(), 8u);
  const double omega = 2 * pi * beam.frequency;
  const double both = damping + 1.0 / 60 / beam.scene.substeps;
  const double expected = std::exp(-0.5 * both * omega * omega * (s.crossings[7] - s.crossings[1]));
  EXPECT_NEAR(s.heights[7] / s.heights[1], expected, 0.03 * expected);
}

// ---- twist ----

// A ring of straight wire with two turns of twist is flat as long as GJ/EI · 2 < √3 (Michell 1889). Beyond,
// it goes into a figure of eight (and, as nothing keeps it from passing through itself here, through it).
float least_width_of_ring(RodBench& bench, uint32_t count) {
  float least = 1;
  for (int k = 0; k < 300; ++k) {
    bench.run(1);
    const std::vector<Vec3> x = bench.positions();
    for (uint32_t i = 0; i < count / 2; ++i) least = std::min(least, length(x[i + count / 2] - x[i]) / 0.4f);
  }
  return least;
}

RodScene twisted_ring(uint32_t count, float share) {
  const double turns = 2;
  cloth::RodParameters p;
  p.closed = true;
  p.straight_at_rest = true;
  p.damping = 0.01f;
  const double bending = p.youngs_modulus * pi / 4 * std::pow(p.radius, 4);
  p.twist_stiffness = static_cast<float>(share * std::sqrt(3.0) / turns * bending);
  std::vector<Vec3> points;
  for (uint32_t i = 0; i < count; ++i) {
    const double a = 2 * pi * i / count;
    points.push_back({0.2f * static_cast<float>(std::cos(a)), 0.2f * static_cast<float>(std::sin(a)),
                      0.002f * static_cast<float>(std::cos(2 * a))});
  }
  RodScene scene;
  scene.gravity = {0, 0, 0};
  scene.add(points, p);
  for (uint32_t k = 0; k < count; ++k) {
    const double half = pi * turns * k / count;
    const Quat twist{0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))};
    scene.rods.frames[k] = scene.rods.frames[k] * twist;
  }
  return scene;
}

TEST_P(RodValidation, TwistedRingBucklesWhereMichellSays) {
  for (uint32_t count : {80u, 120u}) {
    EXPECT_GT(least_width_of_ring(*bench(twisted_ring(count, 0.9f)), count), 0.9f) << count;
    EXPECT_LT(least_width_of_ring(*bench(twisted_ring(count, 1.1f)), count), 0.3f) << count;
  }
}

// Up to six turns, far beyond where a joint's angle is small.
TEST_P(RodValidation, TorqueGrowsWithTheTwist) {
  const uint32_t segments = 40;
  RodScene scene;
  cloth::RodParameters p;
  p.bending_stiffness = 1;  // so that it stays straight
  scene.gravity = {0, 0, 0};
  const float l = 1.0f / segments;
  scene.add(straight({-l, 0, 0}, {1 + l, 0, 0}, segments + 2), p);
  for (uint32_t v : {0u, 1u, segments + 1, segments + 2}) scene.hold(v);
  const auto rods = bench(scene);
  clamp_first(*rods);
  const double stiffness = p.shear_modulus * pi / 2 * std::pow(p.radius, 4);
  const float turn = static_cast<float>(4 * pi);  // in a second
  cloth::SegmentState last{scene.rods.frames.back(), {turn, 0, 0}, true};
  rods->set_state(segments + 1, last);
  for (int second = 1; second <= 3; ++second) {
    rods->run(60);
    last = rods->states().back();
    last.spin = {0, 0, 0};
    rods->set_state(segments + 1, last);
    rods->run(60);
    const double expected = stiffness * turn * second;
    EXPECT_NEAR(rods->torques().front().x, expected, 0.02 * expected) << 2 * second << " turns";
    EXPECT_NEAR(rods->torques().back().x, -expected, 0.02 * expected) << 2 * second << " turns";
    last.spin = {turn, 0, 0};
    rods->set_state(segments + 1, last);
  }
}

MENISCUS_ON_EACH_DEVICE(RodValidation);

}  // namespace

}  // namespace meniscus::tests
