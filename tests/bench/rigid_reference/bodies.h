// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Boxes, their contacts, and what the candidate solvers share.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "collision/rigid_contact/touch.h"
#include "pbd/math/tangents.h"

namespace meniscus::rigid_reference {

constexpr float gravity = 9.81f, friction = 0.5f;

struct Body {
  Pose pose;
  Vec3 half;
  float inverse_mass = 0;         ///< 1/kg; 0: fixed
  Vec3 inverse_inertia{0, 0, 0};  ///< 1/(kg m²), along the box's axes
  Vec3 velocity{0, 0, 0}, angular{0, 0, 0};
  Vec3 moved{0, 0, 0}, turned{0, 0, 0};  ///< since contacts were found: m, rad
};

/// A point of a contact. Impulses last from step to step.
struct Row {
  uint32_t a, b;
  uint32_t feature;
  Vec3 normal, along, across;  ///< from b to a; both directions of friction
  Vec3 arm_a, arm_b;           ///< m, from the centres, when contacts were found
  float distance;              ///< m, then
  float impulse[3] = {};       ///< along the three directions; N·s, or N with vertex block descent
  float penalty[3] = {};       ///< N/m, of vertex block descent
};

inline Body box(Vec3 half, Vec3 position, float density) {
  Body b{{position, {0, 0, 0, 1}}, half};
  if (density == 0) return b;
  const float m = density * 8 * half.x * half.y * half.z;
  const Vec3 s{half.x * half.x, half.y * half.y, half.z * half.z};
  b.inverse_mass = 1 / m;
  b.inverse_inertia = {3 / (m * (s.y + s.z)), 3 / (m * (s.z + s.x)), 3 / (m * (s.x + s.y))};
  return b;
}

inline Vec3 over_inertia(const Body& b, Vec3 torque) {
  const Vec3 local = rotate(conjugate(b.pose.rotation), torque);
  return rotate(b.pose.rotation, {b.inverse_inertia.x * local.x, b.inverse_inertia.y * local.y,
                                  b.inverse_inertia.z * local.z});
}

inline void turn(Body& b, Vec3 by) {
  b.pose.rotation = normalized(rotation_by(by) * b.pose.rotation);
}

inline float inverse_mass_along(const Body& a, const Body& b, const Row& r, Vec3 d) {
  const Vec3 ca = cross(r.arm_a, d), cb = cross(r.arm_b, d);
  return a.inverse_mass + b.inverse_mass + dot(ca, over_inertia(a, ca)) + dot(cb, over_inertia(b, cb));
}

inline Vec3 slip_of(const Body& a, const Body& b, const Row& r) {
  return a.velocity + cross(a.angular, r.arm_a) - b.velocity - cross(b.angular, r.arm_b);
}
/// What the point has moved since contacts were found.
inline Vec3 way_of(const Body& a, const Body& b, const Row& r) {
  return a.moved + cross(a.turned, r.arm_a) - b.moved - cross(b.turned, r.arm_b);
}

inline void push(Body& a, Body& b, const Row& r, Vec3 impulse) {
  a.velocity += a.inverse_mass * impulse;
  a.angular += over_inertia(a, cross(r.arm_a, impulse));
  b.velocity -= b.inverse_mass * impulse;
  b.angular -= over_inertia(b, cross(r.arm_b, impulse));
}

/// Finds all contacts, and gives those that were there before what they had.
inline std::vector<Row> find(std::vector<Body>& bodies, const std::vector<Row>& before) {
  std::vector<Row> rows;
  for (Body& b : bodies) b.moved = b.turned = {0, 0, 0};
  for (uint32_t i = 0; i < bodies.size(); ++i) {
    for (uint32_t j = i + 1; j < bodies.size(); ++j) {
      const Body &a = bodies[j], &b = bodies[i];
      if (a.inverse_mass + b.inverse_mass == 0) continue;
      const Vec3 apart = abs(a.pose.position - b.pose.position);
      if (max_component(apart) > length(a.half) + length(b.half)) continue;
      const collision::Convex of_a{collision::ConvexKind::box, a.half},
          of_b{collision::ConvexKind::box, b.half};
      const collision::Manifold m = collision::touch(a.pose, of_a, b.pose, of_b, 0.02f);
      for (uint32_t k = 0; k < m.count; ++k) {
        Row r{j, i, m.points[k].feature, m.normal, {}, {}, {}, {}, m.points[k].distance};
        const Tangents tangents(m.normal);
        r.along = tangents.u;
        r.across = tangents.v;
        r.arm_a = m.points[k].position - a.pose.position;
        r.arm_b = m.points[k].position - b.pose.position;
        for (const Row& old : before) {
          if (old.a != j || old.b != i || old.feature != r.feature) continue;
          std::copy_n(old.impulse, 3, r.impulse);
          std::copy_n(old.penalty, 3, r.penalty);
        }
        rows.push_back(r);
      }
    }
  }
  return rows;
}

}  // namespace meniscus::rigid_reference
