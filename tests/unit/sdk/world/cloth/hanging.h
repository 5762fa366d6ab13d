// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A world in which cloth hangs at rest, for tests of attachments.
#pragma once

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {

class Hanging {
 protected:
  explicit Hanging(WorldDef def) : world_((def.substeps = 10, def)) {}

  /// A sheet of 0.5 m by 0.5 m that hangs down from its first row, at rest. Thick air takes its swing.
  ClothId hanging_sheet(float top = 0) {
    ClothDef def = sheet(0.5f, 0.5f, 9, 9, {0, top - 0.25f, 0});
    def.pose.rotation = {std::sqrt(0.5f), 0, 0, std::sqrt(0.5f)};
    def.fabric.lift = 0;
    return world_.create_cloth(def);
  }

  /// With air that takes what is left of motion, and a breath of it for the force to be steady.
  void settle(float seconds) {
    world_.set_wind({.air_density = 20});
    run(world_, static_cast<int>(seconds * 60), 1 / 60.0f);
    world_.set_wind({.air_density = 0});
    run(world_, 10, 1 / 60.0f);
  }

  Vec3 mean_force(AttachmentId id, int steps = 30) {
    Vec3 sum{0, 0, 0};
    for (int k = 0; k < steps; ++k) {
      world_.step(1 / 60.0f);
      sum += world_.attachment_force(id) / float(steps);
    }
    return sum;
  }

  World world_;
};

}  // namespace meniscus::tests
