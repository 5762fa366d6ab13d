// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds for tests of several ranks.
#pragma once

#include <cmath>
#include <optional>
#include <span>

#include "tests/worlds.h"

namespace meniscus::tests {

/// A dam of this width and length (m) that breaks along the axis of the slabs, in two fluids, onto a ball and
/// a box. On one thread, or on a GPU of that ordinal. `pulls`: with surface tension. `fixed`: with fixed
/// sums, which GPUs and the pressure grid need. `gridded`: with that grid. `height`, m: of both fluids.
inline World broken_dam(float width, float length = 1.3f, bool pulls = true, std::optional<int> gpu = {},
                        bool fixed = false, RigidSolver rigid = RigidSolver::bullet, bool gridded = false,
                        float height = 0.8f) {
  WorldDef def = world_def(gpu ? pbd::DeviceKind::cuda : pbd::DeviceKind::cpu, 0.05f);
  def.cuda_device = gpu;
  if (gpu || fixed || gridded) def.sums = Sums::fixed;
  if (!gpu) def.threads = 1;
  def.rigid.solver = rigid;
  if (gridded) def.density.solver = DensitySolver::grid;
  def.density.artificial_pressure.strength = 0.05f;
  World world(def);
  FluidDef first, second;
  first.vorticity_confinement = 0.2f;
  if (pulls) {
    first.surface_tension = 0.05f;
    first.cohesion = 0.02f;
  }
  second.rest_density = 500;
  const FluidId a = world.create_fluid(first), b = world.create_fluid(second);
  world.create_shape(tank({0, 0, 0}, {width, height + 0.2f, length + 0.7f}));
  world.create_shape(shape(SphereGeometry{0.15f}, {width / 2, 0.1f, length + 0.4f}));
  world.create_shape(shape(BoxGeometry{{0.1f, 0.2f, 0.05f}}, {0.1f, 0.2f, length + 0.1f}));
  const float middle = 0.625f * height;
  world.add_fluid(block(a, {0, 0, 0}, {width, middle, length}));
  world.add_fluid(block(b, {0, middle, 0}, {width, height, length}));
  return world;
}

constexpr float drop_speed = 1;  // m/s

/// Two drops that meet along the axis of the slabs, without gravity and shapes. On one thread. With a body,
/// they meet on a long box between them.
inline World free_drops(bool has_body = false) {
  WorldDef def = world_def(pbd::DeviceKind::cpu, 0.05f);
  def.threads = 1;
  if (has_body) def.sums = Sums::fixed;
  def.gravity = {0, 0, 0};
  World world(def);
  const FluidId fluid = world.create_fluid({});  // confinement of vorticity would not keep momentum
  for (const float side : {-1.0f, 1.0f}) {
    FluidVolumeDef drop;
    drop.fluid = fluid;
    drop.region = BallRegion{0.25f};
    drop.pose.position = {0.1f * side, 0, 0.3f * side};
    drop.velocity = {0, 0, -side * drop_speed};
    world.add_fluid(drop);
  }
  if (!has_body) return world;
  BodyDef box;
  box.geometry = BoxGeometry{{0.3f, 0.05f, 0.02f}};
  world.create_body(box);
  return world;
}

struct Momentum {
  double x = 0, y = 0, z = 0;  ///< kg m/s
  double mass = 0;             ///< kg
};

inline Momentum momentum_of(const World& world) {
  Momentum sum;
  const std::span<const Vec3> velocities = world.velocities();
  const std::span<const uint32_t> fluids = world.fluids();
  for (size_t k = 0; k < velocities.size(); ++k) {
    const double mass = world.particle_mass(world.fluid_ids()[fluids[k]]);
    sum.x += mass * double{velocities[k].x};
    sum.y += mass * double{velocities[k].y};
    sum.z += mass * double{velocities[k].z};
    sum.mass += mass;
  }
  for (const BodyId id : world.body_ids()) {
    const double mass = world.body_mass(id).mass;
    const Vec3 v = world.body_state(id).velocity;
    sum.x += mass * double{v.x};
    sum.y += mass * double{v.y};
    sum.z += mass * double{v.z};
    sum.mass += mass;
  }
  return sum;
}

}  // namespace meniscus::tests
