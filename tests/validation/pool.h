// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The scene of a pool, for the validation of compression.
#pragma once

#include "tests/validation/measures.h"
#include "tests/validation/scenes.h"

namespace meniscus::tests {

/// A column half as wide as its closed tank, and 4 m high, collapses into a pool 2 m deep. In the fourth
/// second the mean of max(C, 0) must be at most `bar` percent.
inline void expect_pool_settles(pbd::DeviceKind device, float spacing, float step, double bar) {
  World world(world_def(device, spacing));
  record_device(world);
  world.create_shape(tank({0, 0, 0}, {1.6f, 5, 1.6f}));
  world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.8f, 4, 1.6f}));
  Watch watch(world);
  DensityErrors errors;
  while (world.time() < 4) {
    world.step(step);
    const Diagnostics now = world.diagnostics();
    watch.add(now);
    if (world.time() > 3) errors.add(world, now);
  }
  record("mean_depth_m", 2 * mean_height(world));
  errors.record_all();
  watch.expect_sound();
  EXPECT_LE(errors.mean(), bar);
}

}  // namespace meniscus::tests
