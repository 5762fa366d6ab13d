// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The density at which a body neither sinks nor rises.
#pragma once

#include <cmath>
#include <string>

#include "tests/coupling/body_worlds.h"
#include "tests/validation/measures.h"

namespace meniscus::tests {

/// A capsule's surface as the hull of a few rings: a body of many small faces, as meshes are.
inline HullGeometry faceted_capsule(float radius, float half_height) {
  HullGeometry hull;
  constexpr int rings = 7, sides = 14;
  for (int r = 0; r < rings; ++r) {
    const float up = -1.35f + 2.7f * static_cast<float>(r) / (rings - 1);
    for (int k = 0; k < sides; ++k) {
      const float around = 6.2831853f * static_cast<float>(k) / sides;
      hull.points.push_back({radius * std::cos(up) * std::cos(around),
                             radius * std::sin(up) + std::copysign(half_height, up),
                             radius * std::cos(up) * std::sin(around)});
    }
  }
  return hull;
}

/// How far a body has risen, m, in the seconds after it was stopped in mid water. Before that the water has
/// half a second to settle about it.
inline double rise(pbd::DeviceKind device, float size, float spacing, const Geometry& geometry, float density,
                   float seconds) {
  constexpr float dt = 0.016f;
  const float half = 0.5f * size + 5 * spacing, depth = 2 * size + 6 * spacing;
  World world(world_def(device, spacing));
  world.create_shape(tank({-half, 0, -half}, {half, 2 * depth, half}));
  BodyDef def = body(geometry, {0, 0.5f * depth, 0}, density);
  def.can_sleep = false;
  const BodyId id = world.create_body(def);
  world.add_fluid(block(world.create_fluid({}), {-half, 0, -half}, {half, depth, half}));
  run(world, 30, dt);
  world.set_body_velocity(id, {0, 0, 0}, {0, 0, 0});
  const double start = double{world.body_state(id).centre_of_mass.y};
  run(world, static_cast<int>(seconds / dt), dt);
  return double{world.body_state(id).centre_of_mass.y} - start;
}

/// It rises at 980 kg/m³ and sinks at 1020. The density at which these two would balance is recorded.
inline void expect_neutral(pbd::DeviceKind device, float size, float spacing, const std::string& name,
                           const Geometry& geometry, float seconds) {
  const double light = rise(device, size, spacing, geometry, 980, seconds);
  const double heavy = rise(device, size, spacing, geometry, 1020, seconds);
  record(name + "_rise_at_980_m", light);
  record(name + "_rise_at_1020_m", heavy);
  record(name + "_neutral_density", 980 + 40 * light / (light - heavy));
  EXPECT_GT(light, 0) << name;
  EXPECT_LT(heavy, 0) << name;
}

inline HullGeometry cube_hull(float half) {
  HullGeometry hull;
  for (float x : {-half, half}) {
    for (float y : {-half, half}) {
      for (float z : {-half, half}) hull.points.push_back({x, y, z});
    }
  }
  return hull;
}

/// Bodies of this size, m.
inline void expect_all_neutral(pbd::DeviceKind device, float size, float spacing, float seconds) {
  const float r = 0.5f * size;
  const auto expect = [&](const std::string& name, const Geometry& geometry) {
    expect_neutral(device, size, spacing, name, geometry, seconds);
  };
  expect("box", BoxGeometry{{r, r, r}});
  expect("ball", SphereGeometry{r});
  expect("capsule", CapsuleGeometry{0.7f * r, 0.5f * r});
  expect("cube_hull", cube_hull(r));
  // Facets of about a spacing are coarser than what the fluid resolves.
  if (size > 12 * spacing) expect("capsule_hull", faceted_capsule(0.7f * r, 0.5f * r));
}

}  // namespace meniscus::tests
