// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Calls about one body, in a rigid world that has it: that of a World, or one of a batch.
#pragma once

#include "collision/rigid/rigid_world.h"
#include "sdk/world/state/world_tables.h"

namespace meniscus {

/// A body and the rigid world that moves it. Each call throws Error before it changes anything.
struct BodyCalls {
  const BodyEntry& entry;
  collision::RigidWorld& rigid;
  uint32_t number;

  /// `force`: of the particles over the last step.
  BodyState state(const collision::RigidImpulse& force) const;
  void set_velocity(Vec3 velocity, Vec3 angular_velocity) const;
  void apply_force(Vec3 force, Vec3 point) const;
  void apply_torque(Vec3 torque) const;
  void apply_impulse(Vec3 impulse, Vec3 point) const;
  void move(const Pose& target, float duration) const;
};

}  // namespace meniscus
