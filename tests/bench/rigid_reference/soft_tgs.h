// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Small steps of a Gauss–Seidel solver with soft contacts (Catto, "Solver2D", 2024). Each small step is
// solved with the push that removes overlaps, and once more without it.
#pragma once

#include "tests/bench/rigid_reference/bodies.h"

namespace meniscus::rigid_reference {

class SoftTgs {
 public:
  float frequency = 0.125f;  ///< of the rate of small steps
  float damping = 3;         ///< of critical damping
  float push_speed = 3;      ///< m/s, the most with which overlaps are removed

  void step(std::vector<Body>& bodies, float dt, int small_steps) {
    rows_ = find(bodies, rows_);
    h_ = dt / static_cast<float>(small_steps);
    for (int i = 0; i < small_steps; ++i) {
      for (Body& b : bodies)
        if (b.inverse_mass > 0) b.velocity.y -= h_ * gravity;
      for (const Row& r : rows_) {
        push(bodies[r.a], bodies[r.b], r,
             r.impulse[0] * r.normal + r.impulse[1] * r.along + r.impulse[2] * r.across);
      }
      for (Row& r : rows_) solve(bodies[r.a], bodies[r.b], r, true);
      for (Body& b : bodies) {
        b.pose.position += h_ * b.velocity;
        b.moved += h_ * b.velocity;
        b.turned += h_ * b.angular;
        turn(b, h_ * b.angular);
      }
      for (Row& r : rows_) solve(bodies[r.a], bodies[r.b], r, false);
    }
  }

 private:
  void solve(Body& a, Body& b, Row& r, bool removes_overlap) {
    const float distance = r.distance + dot(way_of(a, b, r), r.normal);
    float bias = 0, mass_scale = 1, impulse_scale = 0;
    if (distance > 0) {
      bias = distance / h_;
    } else if (removes_overlap) {
      const float omega = 2 * 3.14159265f * frequency / h_;
      const float a1 = 2 * damping + h_ * omega, a2 = h_ * omega * a1, a3 = 1 / (1 + a2);
      bias = std::max(omega / a1 * distance, -push_speed);
      mass_scale = a2 * a3;
      impulse_scale = a3;
    }
    const float speed = dot(slip_of(a, b, r), r.normal);
    const float change =
        -(mass_scale * (speed + bias)) / inverse_mass_along(a, b, r, r.normal) - impulse_scale * r.impulse[0];
    const float impulse = std::max(r.impulse[0] + change, 0.0f);
    push(a, b, r, (impulse - r.impulse[0]) * r.normal);
    r.impulse[0] = impulse;
    const Vec3 slip = slip_of(a, b, r);
    float u = r.impulse[1] - dot(slip, r.along) / inverse_mass_along(a, b, r, r.along);
    float v = r.impulse[2] - dot(slip, r.across) / inverse_mass_along(a, b, r, r.across);
    const float size = std::sqrt(u * u + v * v), most = friction * impulse;
    if (size > most) u *= most / size, v *= most / size;
    push(a, b, r, (u - r.impulse[1]) * r.along + (v - r.impulse[2]) * r.across);
    r.impulse[1] = u;
    r.impulse[2] = v;
  }

  std::vector<Row> rows_;
  float h_ = 0;
};

}  // namespace meniscus::rigid_reference
