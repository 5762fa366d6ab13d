// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Force fields on rigid bodies, on the host.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include "collision/rigid/rigid_world.h"
#include "sdk/engine/force_fields/force_field.h"

namespace meniscus::force_kernels {

/// Six points on the principal axes of a body, each with a sixth of its mass, at ±s of the centre. Their
/// second moments are those of the body, s² = 3 M/m with M = (I₁ + I₂ + I₃)/2 − I. So a field that is linear
/// in place and velocity gives the body the exact force and torque.
inline std::array<Vec3, 6> points_of(const collision::RigidMass& mass, Quat axes) {
  const auto moment = [](float inverse) { return inverse > 0 ? 1 / inverse : 0.0f; };
  const Vec3 i{moment(mass.inverse_inertia.x), moment(mass.inverse_inertia.y),
               moment(mass.inverse_inertia.z)};
  const float half = 0.5f * (i.x + i.y + i.z);
  const auto reach = [&](float own) {
    return std::sqrt(std::fmax(0.0f, 3 * (half - own) * mass.inverse_mass));
  };
  const Vec3 x = rotate(axes, {reach(i.x), 0, 0}), y = rotate(axes, {0, reach(i.y), 0}),
             z = rotate(axes, {0, 0, reach(i.z)});
  return {x, -x, y, -y, z, -z};
}

/// Changes the velocity of each dynamic body by what the fields, whose grids are on the host, do in dt.
/// `densities` is by body, kg/m³.
inline void push_bodies(collision::RigidWorld& world, std::span<const ForceField> fields,
                        std::span<const float> densities, double time, float dt) {
  const View<const ForceField> all{fields.data(), static_cast<uint32_t>(fields.size())};
  for (uint32_t b = 0; b < world.body_slots() && b < densities.size(); ++b) {
    const collision::RigidMass mass = world.mass(b);
    if (!(mass.inverse_mass > 0)) continue;
    const Vec3 v = world.velocity(b), w = world.angular_velocity(b), centre = world.centre_of_mass(b);
    const Quat axes = world.pose(b).rotation * mass.principal.rotation;
    Vec3 linear{0, 0, 0}, moment{0, 0, 0};  // over the mass
    for (const Vec3 arm : points_of(mass, axes)) {
      const Felt felt{centre + arm, densities[b], ForceField::bodies};
      const Vec3 change = change_by_all(all, felt, v + cross(w, arm), time, dt);
      linear += change / 6.0f;
      moment += cross(arm, change) / 6.0f;
    }
    if (linear == Vec3{0, 0, 0} && moment == Vec3{0, 0, 0}) continue;
    const Vec3 local = rotate(conjugate(axes), moment) / mass.inverse_mass, i = mass.inverse_inertia;
    world.set_velocity(b, v + linear, w + rotate(axes, {i.x * local.x, i.y * local.y, i.z * local.z}));
  }
}

}  // namespace meniscus::force_kernels
