// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies while contacts among solids are solved, and kernels that move them.
#pragma once

#include "collision/rigid_contact/colour_kernels.h"

namespace meniscus::collision::rigid_contact_kernels {

/// A symmetric matrix.
struct Symmetric {
  float xx, yy, zz, xy, yz, zx;

  MENISCUS_HD Vec3 operator*(Vec3 v) const {
    return {xx * v.x + xy * v.y + zx * v.z, xy * v.x + yy * v.y + yz * v.z, zx * v.x + yz * v.y + zz * v.z};
  }
};

/// A body while contacts are solved.
struct MovingBody {
  Vec3 velocity;
  float inverse_mass;
  Vec3 angular;
  Symmetric inverse_inertia;  ///< in world axes, at the start of the step
  Vec3 moved, turned;         ///< since then: m, rad
  Vec3 held, held_angular;    ///< sums of what its contacts exert in a small step: N·s, N·m·s
};

MENISCUS_HD inline MovingBody fixed_body() {
  return {{0, 0, 0}, 0, {0, 0, 0}, {0, 0, 0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
}

/// The matrix with these eigenvalues along the axes of a frame.
MENISCUS_HD inline Symmetric world_inertia(Quat turn, Vec3 diagonal) {
  Symmetric sum{0, 0, 0, 0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 v = rotate(turn, unit_axis(axis)), w = component(diagonal, axis) * v;
    sum = {sum.xx + w.x * v.x, sum.yy + w.y * v.y, sum.zz + w.z * v.z,
           sum.xy + w.x * v.y, sum.yz + w.y * v.z, sum.zx + w.z * v.x};
  }
  return sum;
}

/// The solution of (a b c) x = d, of three columns.
MENISCUS_HD inline Vec3 solve_columns(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 bc = cross(b, c);
  const float determinant = dot(a, bc);
  return Vec3{dot(d, bc), dot(a, cross(d, c)), dot(a, cross(b, d))} / determinant;
}

MENISCUS_HD constexpr Vec3 scaled(Vec3 a, Vec3 b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

/// The angular velocity of a free body after dt, in its own axes. See tumbled() of collision/rigid.
MENISCUS_HD inline Vec3 tumbled(Vec3 before, Vec3 inverse_inertia, float dt) {
  const Vec3 inertia{1 / inverse_inertia.x, 1 / inverse_inertia.y, 1 / inverse_inertia.z};
  const float speed = length(before);
  const float turning = pbd::min(dt, rigid_contact_tuning::most_turn / pbd::max(speed, 1e-30f));
  Vec3 after = before;
  for (int i = 0; i < 3; ++i) {
    const Vec3 w = 0.5f * (before + after), l = scaled(inertia, w);
    const Vec3 error = after - before + turning * scaled(inverse_inertia, cross(w, l));
    if (length(error) <= 1.2e-7f * speed) break;
    // Columns of the derivative of the error: of w × I w along each axis.
    const auto column = [&](Vec3 axis) {
      const Vec3 d = cross(axis, l) + cross(w, scaled(inertia, axis));
      return axis + 0.5f * turning * scaled(inverse_inertia, d);
    };
    after -= solve_columns(column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1}), error);
  }
  return after;
}

struct StartBodies {
  View<const ContactBody> from;
  View<MovingBody> bodies;
  View<Quat> turn;
  float dt;

  MENISCUS_HD void operator()(uint32_t i) const {
    const ContactBody body = from[i];
    MovingBody b = fixed_body();
    b.velocity = body.velocity;
    b.angular = body.angular;
    b.inverse_mass = body.inverse_mass;
    if (body.inverse_mass > 0) {
      b.inverse_inertia = world_inertia(body.pose.rotation, body.inverse_inertia);
      const Vec3 own = rotate(conjugate(body.pose.rotation), body.angular);
      b.angular = rotate(body.pose.rotation, tumbled(own, body.inverse_inertia, dt));
    }
    bodies[i] = b;
    turn[i] = body.pose.rotation;
  }
};

/// Forces and held impulses change velocities.
struct Accelerate {
  View<const ContactBody> start;
  View<MovingBody> bodies;
  float h;

  MENISCUS_HD void operator()(uint32_t i) const {
    MovingBody& b = bodies[i];
    if (b.inverse_mass == 0) return;
    const ContactBody& from = start[i];
    b.velocity = from.kept * b.velocity + h * from.acceleration + b.inverse_mass * b.held;
    b.angular = from.angular_kept * b.angular + b.inverse_inertia * (h * from.torque + b.held_angular);
  }
};

struct Move {
  View<MovingBody> bodies;
  View<Quat> turn;
  float h;

  MENISCUS_HD void operator()(uint32_t i) const {
    MovingBody& b = bodies[i];
    b.moved += h * b.velocity;
    b.turned += h * b.angular;
    turn[i] = normalized(rotation_by(h * b.angular) * turn[i]);
  }
};

struct StoreMotions {
  View<const ContactBody> start;
  View<const MovingBody> bodies;
  View<const Quat> turn;
  View<const uint64_t> colours;  ///< by body: those of its contacts
  View<ContactMotion> out;

  MENISCUS_HD void operator()(uint32_t i) const {
    const MovingBody& b = bodies[i];
    out[i] = {{start[i].pose.position + b.moved, turn[i]}, b.velocity, b.angular, colours[i] != 0};
  }
};

}  // namespace meniscus::collision::rigid_contact_kernels
