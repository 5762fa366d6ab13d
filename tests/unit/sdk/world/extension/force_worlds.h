// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds without gravity, for tests of force fields.
#pragma once

#include "tests/cloth_worlds.h"

namespace meniscus::tests {

inline WorldDef weightless(pbd::DeviceKind device, int substeps = 4) {
  WorldDef def = world_def(device, 0.05f);
  def.gravity = {0, 0, 0};
  def.substeps = substeps;
  def.iterations = 2;
  return def;
}

inline ForceFieldDef field(const Force& force, const char* name = "field") {
  ForceFieldDef def;
  def.name = name;
  def.force = force;
  return def;
}

/// A block whose moments of inertia all differ.
inline BodyDef brick(Vec3 position) {
  BodyDef def;
  def.name = "brick";
  def.geometry = BoxGeometry{{0.1f, 0.2f, 0.3f}};
  def.pose.position = position;
  return def;
}

/// One of each that a field acts on, far from one another, in a vacuum.
struct OneOfEach {
  World world;
  FluidId water = world.create_fluid({});
  FluidId sand = world.create_granular({});
  BodyId body;
  ClothId cloth;
  RopeId cord;

  explicit OneOfEach(const WorldDef& def, Vec3 velocity = {0, 0, 0}) : world(def) {
    world.set_wind({.air_density = 0});
    world.add_particles(water, std::vector<Vec3>{{0, 0, 0}}, std::vector<Vec3>{velocity});
    world.add_particles(sand, std::vector<Vec3>{{2, 0, 0}}, std::vector<Vec3>{velocity});
    BodyDef solid = brick({4, 0, 0});
    solid.velocity = velocity;
    body = world.create_body(solid);
    cloth = world.create_cloth(sheet(0.4f, 0.4f, 4, 4, {6, 0, 0}));
    cord = world.create_rope(rope({{8, 0, 0}, {8.5f, 0, 0}}, 5));
  }

  /// m/s, of the particle, the grain, the body, a vertex of the cloth and one of the rope.
  std::vector<Vec3> velocities() const {
    const auto particles = world.velocities();
    return {particles[0], particles[1], world.body_state(body).velocity, world.cloth_velocities(cloth)[7],
            world.rope_velocities(cord)[2]};
  }
};

inline void expect_near(Vec3 found, Vec3 expected, float tolerance, const std::string& what = "") {
  EXPECT_LT(length(found - expected), tolerance)
      << what << " (" << found.x << ", " << found.y << ", " << found.z << ") is not (" << expected.x << ", "
      << expected.y << ", " << expected.z << ")";
}

}  // namespace meniscus::tests
