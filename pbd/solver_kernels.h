// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The solver's own kernels: prediction, reordering, velocity update and the summary of the state.
#pragma once

#include "pbd/contacts.h"
#include "pbd/device/scalar.h"
#include "pbd/neighbour_search.h"
#include "pbd/particles.h"
#include "pbd/solver.h"

namespace meniscus::pbd::solver_kernels {

/// a + h·b, with the same bits in each kernel: a particle must be in the cell by which it was sorted.
MENISCUS_HD inline Vec3 after(Vec3 a, Vec3 b, float dt) {
  return {multiply_add(dt, b.x, a.x), multiply_add(dt, b.y, a.y), multiply_add(dt, b.z, a.z)};
}

/// v + h·g; fixed particles are not accelerated.
MENISCUS_HD inline Vec3 drawn(const Vec4& position, const Vec4& velocity, Vec3 gravity, float dt) {
  return position.w > 0 ? after(velocity.xyz(), gravity, dt) : velocity.xyz();
}

/// p = x + h·v
MENISCUS_HD inline Vec3 advanced(const Vec4& position, Vec3 velocity, float dt) {
  return after(position.xyz(), velocity, dt);
}

/// The positions of particles without constraints: p = x + h·(v + h·g + Δv).
struct Prediction {
  View<const Vec4> position, velocity;
  Vec3 gravity;
  float dt;
  View<const Vec4> limited{};         ///< the same, with the motions that were limited
  View<const Vec4> changes{};         ///< Δv of external forces, if there are any
  WorldGravities gravities{};         ///< in place of `gravity`, where worlds have their own
  WorldGravities vertex_gravities{};  ///< likewise, by vertex
  uint32_t sorted = ~0u;              ///< see ParticleView; for these

  MENISCUS_HD Vec3 gravity_of(uint32_t i) const {
    return i < sorted ? gravities.of(i, gravity) : vertex_gravities.of(i - sorted, gravity);
  }
  MENISCUS_HD Vec3 velocity_of(uint32_t i, const Vec4& x, const Vec4& v) const {
    const Vec3 fallen = drawn(x, v, gravity_of(i), dt);
    return changes.count ? fallen + load(changes, i).xyz() : fallen;
  }
  MENISCUS_HD Vec4 unlimited(uint32_t i) const {
    const Vec4 x = load(position, i);
    return with_w(advanced(x, velocity_of(i, x, load(velocity, i)), dt), x.w);
  }
  MENISCUS_HD Vec4 operator()(uint32_t i) const { return limited.count ? load(limited, i) : unlimited(i); }
};

struct Predict {
  Prediction prediction;
  View<Vec4> predicted;

  MENISCUS_HD void operator()(uint32_t i) const { predicted[i] = prediction.unlimited(i); }
};

/// Reorders the state into the sorted order, which holds from here on, and adds v += h·g. Unsorted particles
/// keep their places, and may be written over their own input.
struct Reorder {
  CellOrder order;
  Prediction prediction;
  View<const Phase> phase;
  View<const uint32_t> slot, number;
  View<Vec4> sorted_predicted, previous, accumulated_delta, sorted_velocity;
  View<Phase> sorted_phase;
  View<uint32_t> sorted_slot, sorted_number;
  CoarsePositions coarse;  ///< to be filled in, if there are any
  GridView grid;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t from = i < order.placed.count ? order.find(i) : i;
    const Vec4 x = prediction.position[from], before = prediction.velocity[from];
    const Phase present_phase = phase[from];
    const uint32_t present_slot = slot[from], present_number = number[from];
    const Vec3 v = prediction.velocity_of(from, x, before);
    const Vec3 unlimited = advanced(x, v, prediction.dt);
    const Vec3 p = prediction.limited.count ? load(prediction.limited, from).xyz() : unlimited;
    sorted_predicted[i] = with_w(p, x.w);
    previous[i] = x;
    accumulated_delta[i] = with_w(p - unlimited, x.w);
    sorted_velocity[i] = with_w(v, before.w);
    sorted_phase[i] = present_phase;
    sorted_slot[i] = present_slot;
    sorted_number[i] = present_number;
    if (coarse.blocks.count && i < order.placed.count) coarse.put(i, grid, p);
  }
};

/// v = (p − x)/h, without the rounding of p, which would act as a force far from the origin.
struct UpdateVelocity {
  View<const Vec4> position, accumulated_delta;
  View<Vec4> velocity;
  float inverse_dt;
  uint32_t sorted;  ///< see ParticleView

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec4 m = load(accumulated_delta, i);
    if ((i < sorted ? m.w : position[i].w) == 0) return;
    velocity[i] = shifted(velocity[i], inverse_dt * m.xyz());
  }
};

/// Discards the motion of a substep.
struct StopMotion {
  View<Vec4> velocity;

  MENISCUS_HD void operator()(uint32_t i) const { velocity[i] = {0, 0, 0, 0}; }
};

/// Puts back what a relaxation of new particles alone has moved besides them.
struct HoldOthers {
  View<const uint32_t> slot;
  uint32_t sorted;
  uint32_t first;  ///< slot of the new particles
  View<const Vec4> previous;
  View<Vec4> position;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (i < sorted && slot[i] >= first) return;
    position[i] = with_w(previous[i].xyz(), position[i].w);
  }
};

MENISCUS_HD inline ParticleSummary empty_summary() {
  constexpr Vec3 corner{most_finite, most_finite, most_finite};
  return {corner, -corner, 0, 0, no_index};
}

/// A speed whose square exceeds the range of a float counts as non-finite.
struct Summarize {
  View<const Vec4> position, velocity;
  View<const uint32_t> slot;

  MENISCUS_HD ParticleSummary operator()(uint32_t i) const {
    const Vec3 x = position[i].xyz(), v = velocity[i].xyz();
    const float speed2 = dot(v, v);
    if (!is_finite(x) || !(speed2 <= most_finite)) {
      ParticleSummary bad = empty_summary();
      bad.non_finite = 1;
      bad.first_bad_slot = slot[i];
      return bad;
    }
    return {x, x, speed2, 0, no_index};
  }
};

struct MergeSummaries {
  MENISCUS_HD ParticleSummary operator()(const ParticleSummary& a, const ParticleSummary& b) const {
    return {min(a.lower, b.lower), max(a.upper, b.upper), pbd::max(a.max_speed2, b.max_speed2),
            a.non_finite + b.non_finite,
            a.first_bad_slot < b.first_bad_slot ? a.first_bad_slot : b.first_bad_slot};
  }
};

}  // namespace meniscus::pbd::solver_kernels
