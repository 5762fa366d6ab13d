// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The density at which a body neither sinks nor rises.
#pragma once

#include <cmath>
#include <string>

#include "sdk/validation/cases/floating_box.h"
#include "tests/validation/measures.h"
#include "tests/worlds.h"

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

/// It rises at 980 kg/m³ and sinks at 1020. The density at which these two would balance is recorded.
inline void expect_neutral(pbd::DeviceKind device, float size, float spacing, const std::string& name,
                           const Geometry& geometry, float seconds) {
  const WorldDef def = world_def(device, spacing);
  const double light = validation::rise(def, size, geometry, 980, seconds);
  const double heavy = validation::rise(def, size, geometry, 1020, seconds);
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
