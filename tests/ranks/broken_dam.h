// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A world for tests of several ranks.
#pragma once

#include "tests/worlds.h"

namespace meniscus::tests {

/// A dam of this width and length (m) that breaks along the axis of the slabs, in two fluids, onto a ball and
/// a box. On one thread.
inline World broken_dam(float width, float length = 1.3f) {
  WorldDef def = world_def(pbd::DeviceKind::cpu, 0.05f);
  def.threads = 1;
  def.density.artificial_pressure.strength = 0.05f;
  World world(def);
  FluidDef first, second;
  first.vorticity_confinement = 0.2f;
  first.surface_tension = 0.05f;
  first.cohesion = 0.02f;
  second.rest_density = 500;
  const FluidId a = world.create_fluid(first), b = world.create_fluid(second);
  world.create_shape(tank({0, 0, 0}, {width, 1, length + 0.7f}));
  world.create_shape(shape(SphereGeometry{0.15f}, {width / 2, 0.1f, length + 0.4f}));
  world.create_shape(shape(BoxGeometry{{0.1f, 0.2f, 0.05f}}, {0.1f, 0.2f, length + 0.1f}));
  world.add_fluid(block(a, {0, 0, 0}, {width, 0.5f, length}));
  world.add_fluid(block(b, {0, 0.5f, 0}, {width, 0.8f, length}));
  return world;
}

}  // namespace meniscus::tests
