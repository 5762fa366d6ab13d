// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Scenes of rods and ropes for their harness.
#include "tests/bench/harness/rod_bench.h"

#include <cmath>
#include <numbers>

#include "pbd/math/vec.h"

namespace meniscus::tests {

uint32_t RodScene::add(std::span<const Vec3> along, const cloth::RodParameters& parameters) {
  const auto first = static_cast<uint32_t>(points.size());
  const cloth::RodModel rod = cloth::build_rod(along, parameters);
  append(parameters.bends_and_twists ? rods : ropes, rod, first);
  points.insert(points.end(), along.begin(), along.end());
  masses.insert(masses.end(), rod.masses.begin(), rod.masses.end());
  return first;
}

void RodBench::settle(int steps, float share) {
  for (int k = 0; k < steps; ++k) {
    run(1);
    std::vector<Vec3> v = velocities();
    for (Vec3& velocity : v) velocity = share * velocity;
    set_velocities(v);
  }
}

RodScene cantilever(float load, uint32_t segments, int substeps) {
  cloth::RodParameters p;
  const float weight = p.density * std::numbers::pi_v<float> * p.radius * p.radius * 9.81f;  // N/m
  p.youngs_modulus = 4 * weight / (load * std::numbers::pi_v<float> * std::pow(p.radius, 4.0f));
  p.shear_modulus = p.youngs_modulus / 2.6f;
  RodScene scene;
  scene.substeps = substeps;
  const float l = 1 / static_cast<float>(segments);
  scene.add(straight({-l, 0, 0}, {1, 0, 0}, segments + 1), p);
  scene.hold(0);
  scene.hold(1);
  return scene;
}

void clamp_first(RodBench& bench) {
  cloth::SegmentState state = bench.states().front();
  state.held = true;
  bench.set_state(0, state);
}

std::vector<Vec3> straight(Vec3 a, Vec3 b, uint32_t segments) {
  std::vector<Vec3> points;
  for (uint32_t k = 0; k <= segments; ++k)
    points.push_back(a + (static_cast<float>(k) / static_cast<float>(segments)) * (b - a));
  return points;
}

}  // namespace meniscus::tests
