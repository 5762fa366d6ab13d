// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies for worlds of several ranks, and what they do.
#pragma once

#include <sstream>
#include <string>

#include "tests/worlds.h"

namespace meniscus::tests {

/// Adds to a dam of this width and length (m): a box that lands on it across the cuts, a heavy box on the
/// floor that the water comes to, with a film below it, and a ball that is driven into the dam.
inline void add_bodies(World& world, float width, float length) {
  const float middle = width / 2;
  BodyDef floating;
  floating.geometry = BoxGeometry{{0.04f, 0.04f, 0.35f * length}};
  floating.density = 300;
  floating.pose.position = {middle, 0.86f, 0.5f * length};
  floating.velocity = {0, -1, 0};
  world.create_body(floating);

  BodyDef heavy;
  heavy.geometry = BoxGeometry{{0.05f, 0.03f, 0.05f}};
  heavy.density = 2500;
  heavy.pose.position = {middle, 0.03f, length + 0.07f};
  world.create_body(heavy);

  BodyDef driven;
  driven.motion = BodyMotion::kinematic;
  driven.geometry = SphereGeometry{0.06f};
  driven.keyframes = {{0, {{middle, 0.9f, 0.1f * length}}}, {0.3f, {{middle, 0.5f, 0.15f * length}}}};
  world.create_body(driven);
}

/// All that bodies do, with all digits.
inline std::string told_by_bodies(const World& world) {
  std::ostringstream text;
  text.precision(9);
  const auto write = [&](Vec3 v) { text << v.x << ' ' << v.y << ' ' << v.z << ' '; };
  for (const BodyId id : world.body_ids()) {
    const BodyState s = world.body_state(id);
    write(s.pose.position);
    text << s.pose.rotation.x << ' ' << s.pose.rotation.w << ' ';
    for (const Vec3 v : {s.velocity, s.angular_velocity, s.fluid_force, s.fluid_torque}) write(v);
  }
  return text.str();
}

}  // namespace meniscus::tests
