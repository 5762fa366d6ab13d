// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Computes the poses of kinematic bodies.
#include "collision/rigid/kinematics.h"

#include <algorithm>
#include <cmath>

#include "pbd/math/vec.h"

namespace meniscus::collision {

Vec3 turn_between(Quat from, Quat to) {
  const Quat turn = to * conjugate(from);
  const Vec3 v = turn.w < 0 ? Vec3{-turn.x, -turn.y, -turn.z} : Vec3{turn.x, turn.y, turn.z};
  const float sine = length(v);
  if (sine < 1e-6f) return 2.0f * v;
  return 2 * std::atan2(sine, std::fabs(turn.w)) / sine * v;
}

Pose between(const Pose& from, const Pose& to, float fraction) {
  const Quat turn = rotation_by(fraction * turn_between(from.rotation, to.rotation));
  return {from.position + fraction * (to.position - from.position), normalized(turn * from.rotation)};
}

Pose keyframe_pose(const std::vector<Keyframe>& keyframes, bool loop, double time) {
  const double first = keyframes.front().time, last = keyframes.back().time;
  if (loop && time > last && last > first) time = first + std::fmod(time - first, last - first);
  if (time <= first) return keyframes.front().pose;
  if (time >= last) return keyframes.back().pose;
  const auto next =
      std::ranges::upper_bound(keyframes, time, {}, [](const Keyframe& k) { return double{k.time}; });
  const Keyframe &a = *(next - 1), &b = *next;
  return between(a.pose, b.pose, static_cast<float>((time - a.time) / (double{b.time} - a.time)));
}

Pose move_pose(const KinematicMove& move, double time) {
  const double passed = time - move.start;
  if (!(passed < move.duration)) return move.to;
  return between(move.from, move.to, static_cast<float>(passed / move.duration));
}

}  // namespace meniscus::collision
