// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A world for tests of several ranks.
#pragma once

#include <optional>

#include "tests/worlds.h"

namespace meniscus::tests {

/// A dam of this width (m) that breaks along the axis of the slabs, in two fluids, onto a ball and a box. On
/// one thread, or on a GPU of that ordinal.
inline World broken_dam(float width, std::optional<int> gpu = {}) {
  WorldDef def = world_def(gpu ? pbd::DeviceKind::cuda : pbd::DeviceKind::cpu, 0.05f);
  def.cuda_device = gpu;
  if (gpu)
    def.sums = Sums::fixed;
  else
    def.threads = 1;
  def.density.artificial_pressure.strength = 0.05f;
  World world(def);
  FluidDef first, second;
  first.vorticity_confinement = 0.2f;
  first.surface_tension = 0.05f;
  first.cohesion = 0.02f;
  second.rest_density = 500;
  const FluidId a = world.create_fluid(first), b = world.create_fluid(second);
  world.create_shape(tank({0, 0, 0}, {width, 1, 2}));
  world.create_shape(shape(SphereGeometry{0.15f}, {width / 2, 0.1f, 1.7f}));
  world.create_shape(shape(BoxGeometry{{0.1f, 0.2f, 0.05f}}, {0.1f, 0.2f, 1.4f}));
  world.add_fluid(block(a, {0, 0, 0}, {width, 0.5f, 1.3f}));
  world.add_fluid(block(b, {0, 0.5f, 0}, {width, 0.8f, 1.3f}));
  return world;
}

}  // namespace meniscus::tests
