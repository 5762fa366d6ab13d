// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Extended position-based dynamics in small steps (Müller et al. 2020), with contacts without compliance.
#pragma once

#include "tests/bench/rigid_reference/bodies.h"

namespace meniscus::rigid_reference {

class Xpbd {
 public:
  void step(std::vector<Body>& bodies, float dt, int small_steps) {
    std::vector<Row> rows = find(bodies, {});
    h_ = dt / static_cast<float>(small_steps);
    for (int i = 0; i < small_steps; ++i) {
      before_ = bodies;
      for (Body& b : bodies) {
        if (b.inverse_mass > 0) b.velocity.y -= h_ * gravity;
        move(b, h_ * b.velocity, h_ * b.angular);
      }
      for (Row& r : rows) solve_position(bodies, r);
      for (size_t k = 0; k < bodies.size(); ++k) {
        Body& b = bodies[k];
        if (b.inverse_mass == 0) continue;
        b.velocity = (b.moved - before_[k].moved) / h_;
        b.angular = (b.turned - before_[k].turned) / h_;
      }
      for (Row& r : rows) solve_velocity(bodies[r.a], bodies[r.b], r);
    }
  }

 private:
  static void move(Body& b, Vec3 by, Vec3 turned) {
    b.pose.position += by;
    b.moved += by;
    b.turned += turned;
    turn(b, turned);
  }
  /// Moves both by an impulse times time.
  static void displace(Body& a, Body& b, const Row& r, Vec3 p) {
    move(a, a.inverse_mass * p, over_inertia(a, cross(r.arm_a, p)));
    move(b, -b.inverse_mass * p, -over_inertia(b, cross(r.arm_b, p)));
  }

  void solve_position(std::vector<Body>& bodies, Row& r) {
    Body &a = bodies[r.a], &b = bodies[r.b];
    std::fill_n(r.impulse, 3, 0.0f);
    const float distance = r.distance + dot(way_of(a, b, r), r.normal);
    if (distance >= 0) return;
    r.impulse[0] = -distance / inverse_mass_along(a, b, r, r.normal);
    displace(a, b, r, r.impulse[0] * r.normal);
    // Static friction: all of the slip of this small step, or none.
    Vec3 slip = way_of(a, b, r) - way_of(before_[r.a], before_[r.b], r);
    slip -= dot(slip, r.normal) * r.normal;
    const float size = length(slip);
    if (size < 1e-12f) return;
    const float needed = size / inverse_mass_along(a, b, r, slip / size);
    if (needed < friction * r.impulse[0]) displace(a, b, r, -(needed / size) * slip);
  }

  void solve_velocity(Body& a, Body& b, Row& r) {
    if (r.impulse[0] == 0) return;
    Vec3 slip = slip_of(a, b, r);
    const float speed = dot(slip, r.normal);
    slip -= speed * r.normal;
    if (const float size = length(slip); size > 1e-12f) {
      const float needed = size / inverse_mass_along(a, b, r, slip / size);
      push(a, b, r, -(std::min(needed, friction * r.impulse[0] / h_) / size) * slip);
    }
    // Restitution 0: what the positions' push left of speed apart goes.
    if (speed > 0 && dot(slip_of(before_[r.a], before_[r.b], r), r.normal) <= 0)
      push(a, b, r, -(speed / inverse_mass_along(a, b, r, r.normal)) * r.normal);
  }

  std::vector<Body> before_;
  float h_ = 0;
};

}  // namespace meniscus::rigid_reference
