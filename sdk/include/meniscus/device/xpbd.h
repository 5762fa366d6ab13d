// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// One projection of a user's constraint, on either device.
#pragma once

#include <meniscus/device/vector.h>

#include <cstdint>

namespace meniscus::device {

/// The arrays of a substep that projections use: see SubstepView.
struct XpbdArrays {
  float* positions;       ///< m, and inverse mass, 1/kg
  float* corrections;     ///< m, and a word of the solver
  const uint32_t* place;  ///< by slot: where the particle stands in this substep
  uint32_t particles;     ///< of fluids and grains
  float inverse_dt2;      ///< 1/s²
};

/// Numbers from here on are vertices of cloth and ropes.
inline constexpr uint32_t first_vertex = 1u << 31;

/// Solves one constraint C(x) = 0 with compliance α (m/N) by XPBD (Macklin, Müller & Chentanez 2016, eq. 18):
/// Δλ = −(C + α̃ λ)/(Σ w |∇C|² + α̃), α̃ = α/h², and x ← x + w ∇C Δλ. λ is in kg·m where C is in m.
template <class Constraint>
MENISCUS_BOTH_DEVICES void project(const Constraint& constraint, float& multiplier,
                                   const XpbdArrays& arrays) {
  constexpr uint32_t count = Constraint::point_count;
  uint32_t at[count];
  Vec3 x[count], gradient[count];
  float inverse_mass[count];
  for (uint32_t k = 0; k < count; ++k) {
    const uint32_t number = constraint.points[k];
    at[k] = 4 * (number >= first_vertex ? arrays.particles + (number - first_vertex) : arrays.place[number]);
    const float* const p = arrays.positions + at[k];
    x[k] = {p[0], p[1], p[2]};
    inverse_mass[k] = p[3];
    gradient[k] = {0, 0, 0};
  }
  const float value = constraint.value(x, gradient);
  const float softness = constraint.compliance * arrays.inverse_dt2;
  float response = softness;
  for (uint32_t k = 0; k < count; ++k) response += inverse_mass[k] * inner(gradient[k], gradient[k]);
  if (!(response > 0)) return;
  const float change = -(value + softness * multiplier) / response;
  multiplier += change;
  for (uint32_t k = 0; k < count; ++k) {
    const Vec3 moved = product(inverse_mass[k] * change, gradient[k]);
    float *const p = arrays.positions + at[k], *const c = arrays.corrections + at[k];
    p[0] += moved.x, p[1] += moved.y, p[2] += moved.z;
    c[0] += moved.x, c[1] += moved.y, c[2] += moved.z;
  }
}

// ---- the loops of a substep ----

/// Finds where the particle of each slot stands.
struct FindPlaces {
  const uint32_t* slots;
  uint32_t* place;

  MENISCUS_BOTH_DEVICES void operator()(uint32_t i) const { place[slots[i]] = i; }  ///< of particle i
};

/// Sets numbers to 0.
struct Clear {
  float* values;

  MENISCUS_BOTH_DEVICES void operator()(uint32_t i) const { values[i] = 0; }  ///< of number i
};

/// Projects constraints of one colour.
template <class Constraint>
struct Project {
  const Constraint* constraints;
  float* multipliers;
  XpbdArrays arrays;

  MENISCUS_BOTH_DEVICES void operator()(uint32_t i) const {  ///< of constraint i
    project(constraints[i], multipliers[i], arrays);
  }
};

}  // namespace meniscus::device
