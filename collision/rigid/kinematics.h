// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Poses of bodies that only their user moves.
#pragma once

#include <meniscus/bodies.h>

#include <vector>

namespace meniscus::collision {

/// The pose at a fraction of the motion: positions on a line, rotations about one axis at a constant rate.
Pose between(const Pose& from, const Pose& to, float fraction);

/// The pose of keyframes, of which there must be at least one, at a time in s. With `loop` the time after the
/// last one starts again at the first.
Pose keyframe_pose(const std::vector<Keyframe>& keyframes, bool loop, double time);

/// The rotation vector, rad, whose exponential map takes one rotation to another by the shorter way.
Vec3 turn_between(Quat from, Quat to);

/// A motion to a target at a constant rate, and then rest there.
struct KinematicMove {
  Pose from, to;
  double start = 0;    ///< s
  float duration = 0;  ///< s
};
Pose move_pose(const KinematicMove& move, double time);

}  // namespace meniscus::collision
