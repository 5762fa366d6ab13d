// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rods and ropes in the solver, against closed forms and conservation laws.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "pbd/math/vec.h"
#include "tests/bench/harness/rod_bench.h"
#include "tests/devices.h"
#include "tests/many_threads.h"

namespace meniscus::tests {

namespace {

using cloth::RodParameters;
using cloth::SegmentState;

constexpr double pi = std::numbers::pi;

class Rods : public OnDevice {
 protected:
  std::unique_ptr<RodBench> bench(const RodScene& scene) { return make_rod_bench(GetParam(), scene); }
};

/// A helix that is thrown so that it stretches, bends and twists.
struct Thrown {
  RodScene scene;
  std::vector<Vec3> velocities;

  explicit Thrown(bool bends, uint32_t segments = 24) {
    RodParameters p;
    p.bends_and_twists = bends;
    std::vector<Vec3> points;
    for (uint32_t i = 0; i <= segments; ++i) {
      const float t = 6.0f * static_cast<float>(i) / static_cast<float>(segments);
      points.push_back({0.2f * std::cos(t), 0.2f * std::sin(t), 0.1f * t});
      velocities.push_back({std::sin(3 * t) + 0.3f, std::cos(5 * t), std::sin(7 * t + 1)});
    }
    scene.add(points, p);
    scene.gravity = {0, 0, 0};
  }
};

struct Motion {
  double momentum[3] = {};
  double energy = 0;

  Motion(const RodScene& scene, const std::vector<Vec3>& velocities) {
    for (size_t i = 0; i < velocities.size(); ++i) {
      const Vec3 v = velocities[i];
      const double m = scene.masses[i];
      momentum[0] += m * v.x;
      momentum[1] += m * v.y;
      momentum[2] += m * v.z;
      energy += 0.5 * m * dot(v, v);
    }
  }
};

void expect_momentum_kept(RodBench& bench, const Thrown& thrown) {
  bench.set_velocities(thrown.velocities);
  const Motion before(thrown.scene, thrown.velocities);
  double scale = 0;
  for (size_t i = 0; i < thrown.velocities.size(); ++i)
    scale += thrown.scene.masses[i] * length(thrown.velocities[i]);
  for (int k = 0; k < 10; ++k) {
    bench.run(6);
    const Motion now(thrown.scene, bench.velocities());
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(now.momentum[axis], before.momentum[axis], 1e-5 * scale) << "axis " << axis;
    EXPECT_LE(now.energy, before.energy) << "after step " << 6 * (k + 1);
  }
}

TEST_P(Rods, FreeRodKeepsItsMomentumAndGainsNoEnergy) {
  const Thrown thrown(true);
  expect_momentum_kept(*bench(thrown.scene), thrown);
}

TEST_P(Rods, FreeRopeKeepsItsMomentumAndGainsNoEnergy) {
  const Thrown thrown(false);
  expect_momentum_kept(*bench(thrown.scene), thrown);
}

TEST_P(Rods, FreeRodAtRestStaysAsItIs) {
  Thrown thrown(true);
  const auto rods = bench(thrown.scene);
  rods->run(60);
  const std::vector<Vec3> x = rods->positions();
  for (size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(length(x[i] - thrown.scene.points[i]), 0, 1e-5);
}

// ---- a hanging chain ----

struct Catenary {
  float sag, end_angle;  // m, degrees
};

/// A rope of the given length between two points 1 m apart, at rest.
Catenary hang(RodBench& bench) {
  bench.settle(300, 0.97f);
  const std::vector<Vec3> x = bench.positions();
  float lowest = 0;
  for (Vec3 p : x) lowest = std::min(lowest, p.y);
  const auto angle = [&](size_t k) { return std::atan2(x[k].y - x[k + 1].y, x[k + 1].x - x[k].x); };
  const float end = 1.5f * angle(0) - 0.5f * angle(1);  // segments have the angle of their middle
  return {-lowest, end * 180 / static_cast<float>(pi)};
}

RodScene chain(float length, uint32_t segments, int substeps) {
  RodParameters p;
  p.bends_and_twists = false;
  p.stretch_stiffness = 1e6f;
  const float depth = std::sqrt(0.25f * length * length - 0.25f);
  std::vector<Vec3> points = straight({0, 0, 0}, {0.5f, -depth, 0}, segments / 2);
  const std::vector<Vec3> up = straight({0.5f, -depth, 0}, {1, 0, 0}, segments / 2);
  points.insert(points.end(), up.begin() + 1, up.end());
  RodScene scene;
  scene.substeps = substeps;
  scene.add(points, p);
  scene.hold(0);
  scene.hold(segments);
  return scene;
}

TEST_P(Rods, RopeHangsInACatenary) {
  for (int substeps : {5, 20}) {
    for (uint32_t segments : {40u, 120u}) {
      const Catenary shallow = hang(*bench(chain(1.2f, segments, substeps)));
      EXPECT_NEAR(shallow.sag, 0.2923, 0.01 * 0.2923) << substeps << " substeps, " << segments;
      EXPECT_NEAR(shallow.end_angle, 51.95, 0.01 * 51.95) << substeps << " substeps, " << segments;
      const Catenary deep = hang(*bench(chain(2, segments, substeps)));
      EXPECT_NEAR(deep.sag, 0.7964, 0.01 * 0.7964) << substeps << " substeps, " << segments;
      EXPECT_NEAR(deep.end_angle, 77.07, 0.01 * 77.07) << substeps << " substeps, " << segments;
    }
  }
}

TEST_P(Rods, RopeCarriesAHundredThousandTimesItsVertex) {
  for (bool bends : {false, true}) {
    RodScene scene;
    RodParameters p;
    p.bends_and_twists = bends;
    p.stretch_stiffness = 1e6f;
    scene.add(straight({0, 0, 0}, {1, 0, 0}, 40), p);
    scene.hold(0);
    const float load = scene.masses[40] *= 1e5f;
    const auto rods = bench(scene);
    float longest = 0;
    for (int k = 0; k < 90; ++k) {  // it swings through: up to three times its weight
      rods->run(1);
      const std::vector<Vec3> x = rods->positions();
      float total = 0;
      for (size_t i = 0; i + 1 < x.size(); ++i) total += length(x[i + 1] - x[i]);
      longest = std::max(longest, total);
    }
    const float stretch = 3 * load * 9.81f / 1e6f;
    EXPECT_NEAR(longest, 1 + stretch, 0.1f * stretch) << (bends ? "rod" : "rope");
  }
}

TEST_P(Rods, LoopKeepsItsLength) {
  for (bool bends : {false, true}) {
    RodScene scene;
    RodParameters p;
    p.closed = true;
    p.bends_and_twists = bends;
    p.stretch_stiffness = 1e6f;
    std::vector<Vec3> points;
    for (int i = 0; i < 60; ++i) {
      const double a = 2 * pi * i / 60;
      points.push_back({0.2f * static_cast<float>(std::sin(a)), 0.2f * static_cast<float>(std::cos(a)), 0});
    }
    scene.add(points, p);
    scene.hold(0);
    scene.hold(15);
    const auto rods = bench(scene);
    rods->run(90);
    const std::vector<Vec3> x = rods->positions();
    for (const cloth::RodSegment& s : (bends ? scene.rods : scene.ropes).segments)
      EXPECT_NEAR(length(x[s.b] - x[s.a]) / s.rest_length, 1, 1e-3) << (bends ? "rod" : "rope");
  }
}

TEST_P(Rods, TensionAndReactionAreTheWeightBelow) {
  for (bool bends : {false, true}) {
    RodScene scene;
    RodParameters p;
    p.bends_and_twists = bends;
    scene.add(straight({0, 0, 0}, {0, -1, 0}, 10), p);
    scene.hold(0);
    const auto rods = bench(scene);
    rods->settle(120, 0.9f);
    const std::vector<float> tensions = rods->tensions();
    float below = 0;
    for (size_t k = 10; k-- > 0;) {
      below += scene.masses[k + 1] * 9.81f;
      if (!bends) {
        EXPECT_NEAR(tensions[k], below, 1e-3f * below + 4e-4f) << "segment " << k;
      }
    }
    EXPECT_NEAR(rods->reactions(1.0f / 60)[0].y, -below, 1e-3f * below) << (bends ? "rod" : "rope");
  }
}

TEST_P(Rods, NeighboursThatAreHeldDoNoHarm) {
  for (bool bends : {false, true}) {
    RodScene scene;
    RodParameters p;
    p.bends_and_twists = bends;
    p.stretch_stiffness = std::numeric_limits<float>::infinity();
    scene.add(straight({0, 0, 0}, {1, 0, 0}, 8), p);
    for (uint32_t v : {0u, 1u, 2u, 5u, 6u}) scene.hold(v);
    const auto rods = bench(scene);
    if (bends) {
      for (uint32_t k : {0u, 1u}) rods->set_state(k, {scene.rods.frames[k], {0, 0, 0}, true});
    }
    rods->run(60);
    const std::vector<Vec3> x = rods->positions();
    for (uint32_t i = 0; i < 8; ++i) EXPECT_NEAR(length(x[i + 1] - x[i]), 0.125f, 1e-4f) << "segment " << i;
  }
}

// ---- bending and twist ----

TEST_P(Rods, ClampedRodSagsAsTheElasticaDoes) {
  struct Case {
    float load, drop;
  };
  for (const Case c : {Case{1, 0.1235f}, Case{10, 0.7002f}}) {
    const auto rods = bench(cantilever(c.load, 20, 5));
    clamp_first(*rods);
    rods->settle(400, 0.96f);
    EXPECT_NEAR(-rods->positions().back().y, c.drop, 0.02f * c.drop) << "B = " << c.load;
  }
}

TEST_P(Rods, TwistedRodCarriesTheTorque) {
  RodScene scene;
  RodParameters p;
  const uint32_t segments = 20;
  scene.gravity = {0, 0, 0};
  scene.add(straight({-0.05f, 0, 0}, {1.05f, 0, 0}, segments + 2), p);
  for (uint32_t v : {0u, 1u, segments + 1, segments + 2}) scene.hold(v);
  const auto rods = bench(scene);
  clamp_first(*rods);
  const float angle = 2;
  SegmentState last{scene.rods.frames.back(), {2 * angle, 0, 0}, true};
  rods->set_state(segments + 1, last);
  rods->run(30);  // ½ s
  last = rods->states().back();
  last.spin = {0, 0, 0};
  rods->set_state(segments + 1, last);
  rods->run(120);
  const double stiffness = p.shear_modulus * pi / 2 * std::pow(p.radius, 4);
  const std::vector<Vec3> torques = rods->torques();
  EXPECT_NEAR(torques.front().x, stiffness * angle, 0.01 * stiffness * angle);
  EXPECT_NEAR(torques.back().x, -stiffness * angle, 0.01 * stiffness * angle);
}

TEST_P(Rods, HeldSegmentTurnsAsItsSpinSays) {
  RodScene scene;
  scene.gravity = {0, 0, 0};
  scene.add(straight({0, 0, 0}, {1, 0, 0}, 4), {});
  scene.hold(0);
  scene.hold(1);
  const auto rods = bench(scene);
  rods->set_state(0, {scene.rods.frames[0], {3, 0, 0}, true});
  rods->run(60);
  const SegmentState state = rods->states()[0];
  const Quat turned = state.frame * conjugate(scene.rods.frames[0]);
  EXPECT_NEAR(2 * std::atan2(turned.x, turned.w), 3, 1e-3);
  EXPECT_TRUE(state.held);
  EXPECT_EQ(state.spin.x, 3);
}

// ---- state ----

TEST_P(Rods, RestoredStateIsTheOneSaved) {
  const Thrown thrown(true);
  const auto rods = bench(thrown.scene);
  rods->set_velocities(thrown.velocities);
  rods->run(5);
  const std::vector<SegmentState> before = rods->states();
  rods->save();
  rods->run(1);
  EXPECT_NE(rods->states()[3].frame.x, before[3].frame.x);
  rods->restore();
  const std::vector<SegmentState> after = rods->states();
  for (size_t k = 0; k < before.size(); ++k) {
    EXPECT_EQ(after[k].frame.x, before[k].frame.x);
    EXPECT_TRUE(after[k].spin == before[k].spin);
  }
}

TEST_P(Rods, AddingARodLeavesTheOthersAsTheyAre) {
  Thrown thrown(true);
  const auto rods = bench(thrown.scene);
  rods->set_velocities(thrown.velocities);
  rods->run(5);
  const std::vector<SegmentState> before = rods->states();
  cloth::RodModel more = thrown.scene.rods;
  append(more, cloth::build_rod(straight({0, 1, 0}, {1, 1, 0}, 3), {}), 25);
  rods->set_rods(more);
  const std::vector<SegmentState> after = rods->states();
  ASSERT_EQ(after.size(), before.size() + 3);
  for (size_t k = 0; k < before.size(); ++k) {
    EXPECT_EQ(after[k].frame.x, before[k].frame.x);
    EXPECT_TRUE(after[k].spin == before[k].spin);
  }
  EXPECT_FALSE(after.back().held);
}

MENISCUS_ON_EACH_DEVICE(Rods);

TEST(RodThreads, DoNotChangeTheBits) {
  const ManyThreads threads;
  RodScene scene;
  for (int k = 0; k < 300; ++k) {
    RodParameters p;
    p.bends_and_twists = k % 2;
    const float z = 0.1f * static_cast<float>(k);
    scene.hold(scene.add(straight({0, 0, z}, {1, 0, z}, 5), p));
  }
  const auto one = make_cpu_rod_bench(scene, 1), many = make_cpu_rod_bench(scene, 8);
  one->run(5);
  many->run(5);
  const std::vector<Vec3> a = one->positions(), b = many->positions();
  for (size_t i = 0; i < a.size(); ++i) ASSERT_TRUE(a[i] == b[i]) << "vertex " << i;
}

}  // namespace

}  // namespace meniscus::tests
