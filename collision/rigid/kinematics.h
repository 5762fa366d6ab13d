// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Where bodies are that nothing but their user moves.
#pragma once

#include <meniscus/bodies.h>

#include <vector>

namespace meniscus::collision {

/// The pose a share of the way along: positions on a line, rotations about one axis at an even rate.
Pose between(const Pose& from, const Pose& to, float fraction);

/// Of keyframes, of which there must be one, at a time in s. With `loop` the time after the last is counted
/// from the first again.
Pose keyframe_pose(const std::vector<Keyframe>& keyframes, bool loop, double time);

/// The rotation vector, rad, whose exponential map takes one rotation to another the short way.
Vec3 turn_between(Quat from, Quat to);

/// A move to a target at an even rate, and a stay there.
struct KinematicMove {
  Pose from, to;
  double start = 0;    ///< s
  float duration = 0;  ///< s
};
Pose move_pose(const KinematicMove& move, double time);

}  // namespace meniscus::collision
