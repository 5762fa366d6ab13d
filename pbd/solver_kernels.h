// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "pbd/contacts.h"
#include "pbd/particles.h"
#include "pbd/solver.h"

namespace meniscus::pbd::solver_kernels {

/// v += h·g; p = x + h·v; both in sorted order, as are all arrays from here on.
struct Predict {
  View<const uint32_t> order;
  View<const Vec4> position, velocity;
  View<const Phase> phase;
  View<const uint32_t> slot;
  View<Vec4> predicted, previous, sorted_velocity;
  View<Phase> sorted_phase;
  View<uint32_t> sorted_slot;
  Vec3 gravity;
  float dt;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t from = order[i];
    const Vec4 x = position[from];
    Vec3 v = velocity[from].xyz();
    if (x.w > 0) v += dt * gravity;
    previous[i] = x;
    sorted_velocity[i] = with_w(v, 0);
    predicted[i] = with_w(x.xyz() + dt * v, x.w);
    sorted_phase[i] = phase[from];
    sorted_slot[i] = slot[from];
  }
};

/// v = (p − x) / h.
struct UpdateVelocity {
  View<const Vec4> position, previous;
  View<Vec4> velocity;
  float inverse_dt;

  MENISCUS_HD void operator()(uint32_t i) const {
    velocity[i] = with_w(inverse_dt * (position[i].xyz() - previous[i].xyz()), 0);
  }
};

/// Drops the motion of a substep.
struct StopMotion {
  View<Vec4> velocity;

  MENISCUS_HD void operator()(uint32_t i) const { velocity[i] = {0, 0, 0, 0}; }
};

MENISCUS_HD inline ParticleSummary empty_summary() {
  constexpr float big = 3e38f;
  return {{big, big, big}, {-big, -big, -big}, 0, 0, no_index};
}

struct Summarize {
  View<const Vec4> position, velocity;
  View<const uint32_t> slot;

  MENISCUS_HD ParticleSummary operator()(uint32_t i) const {
    const Vec3 x = position[i].xyz(), v = velocity[i].xyz();
    if (!is_finite(x) || !is_finite(v)) {
      ParticleSummary bad = empty_summary();
      bad.non_finite = 1;
      bad.first_bad_slot = slot[i];
      return bad;
    }
    return {x, x, dot(v, v), 0, no_index};
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
