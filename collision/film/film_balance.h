// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels that let films bear what particles do not.
//
// Particles exert on the exposed faces of a body several percent more or less than the fluid's pressure. At
// the rim of a film they also press on the edges of the covered faces. Where no face is covered, these errors
// balance, as the fluid around the body is at rest. A film would not balance them. So it bears the difference
// between what the pressure at its rim means for the exposed faces and what particles exert on them. The
// error of that pressure cancels too: it acts on the film as it acts on the other faces.
#pragma once

#include "collision/film/film_kernels.h"
#include "pbd/device/base/atomics.h"

namespace meniscus::collision::film_kernels {

MENISCUS_HD inline float mean_pressure(const FilmTriangle& t, View<const float> pressure) {
  return (1.0f / 3) * (pressure[t.corner[0]] + pressure[t.corner[1]] + pressure[t.corner[2]]);
}

/// Impulses as integers: their sums do not depend on the order.
struct WholeImpulse {
  int64_t part[6];  ///< force, then torque, in film_tuning::unit

  /// What is not a number counts as the least one, so that the step which has it fails.
  MENISCUS_HD static int64_t whole(float x) {
    constexpr double most = 0x1p61;
    const double units = double{x} * (1 / film_tuning::unit);
    return static_cast<int64_t>(units > most ? most : units >= -most ? units : -most);
  }
  MENISCUS_HD void add(Vec3 force, Vec3 torque) {
    const float parts[] = {force.x, force.y, force.z, torque.x, torque.y, torque.z};
    for (int k = 0; k < 6; ++k) pbd::atomic_add(part[k], whole(parts[k]));
  }
  MENISCUS_HD float at(int k) const {
    return static_cast<float>(static_cast<double>(part[k]) * film_tuning::unit);
  }
};

/// Impulses against gravity, N·s, and their moments across it, N·m·s, in film_tuning::unit.
struct UpwardImpulse {
  int64_t sum, first, second;

  MENISCUS_HD void add(const LevelAxes& axes, float upward, Vec3 arm) {
    pbd::atomic_add(sum, WholeImpulse::whole(upward));
    pbd::atomic_add(first, WholeImpulse::whole(upward * dot(arm, axes.first)));
    pbd::atomic_add(second, WholeImpulse::whole(upward * dot(arm, axes.second)));
  }
};

/// The same as forces: N, N·m.
struct UpwardForce {
  float sum, first, second;
};

MENISCUS_HD inline UpwardForce per_time(const UpwardImpulse& i, float dt) {
  const auto force = [&](int64_t units) {
    return static_cast<float>(static_cast<double>(units) * film_tuning::unit) / dt;
  };
  return {force(i.sum), force(i.first), force(i.second)};
}

/// What particles exert on a body with a film.
struct ParticleLoad {
  UpwardImpulse up;  ///< in all
  int64_t across;    ///< level, across gaps that have a film. Such a particle touches both faces.
};

/// Sums what particles exert on bodies with films.
struct AddParticleLoads {
  pbd::ContactView contacts;
  View<const pbd::Vec4> position;
  View<const pbd::Phase> phase;
  uint32_t sorted;
  View<const uint32_t> has_film;
  Lengths lengths;
  WorldAxes world_axes;
  float inverse_dt;
  View<ParticleLoad> loads;  ///< by body

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n >= contacts.total()) return;
    const pbd::Contact& c = contacts.contacts[n];
    const uint32_t i = contacts.particle[n];
    if (c.body >= has_film.count || !has_film[c.body] || i >= sorted || pbd::is_grain(phase[i])) return;
    const LevelAxes& axes = world_axes.of(c.body);
    const Vec3 x = position[i].xyz(), push = -inverse_dt * multiplier_sum(c);
    const float upward = dot(push, axes.up);
    loads[c.body].up.add(axes, upward, c.arm);
    const Vec3 level = push - upward * axes.up;
    float most = 0;
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      const pbd::Contact& other = contacts.contacts[k];
      if (k == n || other.body == c.body) continue;
      const float gap = plane_distance(c, x) + plane_distance(other, x);
      most =
          pbd::max(most, lengths.film_between(gap, -dot(c.normal, other.normal)) * dot(level, other.normal));
    }
    if (most > 0) pbd::atomic_add(loads[c.body].across, WholeImpulse::whole(most));
  }
};

/// How a body's film is loaded.
struct Balance {
  UpwardForce lacking;  ///< what particles should exert on the exposed faces beyond what they do
  float load;           ///< N, of the film's pressure
  float centre[2];      ///< m, where that acts, along LevelAxes::first and second from the body's centre
  float spread[3];      ///< m²: the mean square of the film's distance from there, and the mean product
  float level;          ///< of the film's load across gravity, the part that is exerted
  float upright;        ///< of the load along gravity, the same; at the centre
  float slope[2];       ///< 1/m, of the same

  MENISCUS_HD float upright_at(const LevelAxes& axes, Vec3 arm) const {
    return upright + slope[0] * (dot(arm, axes.first) - centre[0]) +
           slope[1] * (dot(arm, axes.second) - centre[1]);
  }
  /// Finds what is exerted, where the films of other bodies exert this much beyond their pressure.
  MENISCUS_HD void find(const UpwardForce& passed_on) {
    upright = slope[0] = slope[1] = 0;
    if (!(fabsf(load) > 0)) return;
    const float sum = (lacking.sum - passed_on.sum) / load;
    upright = pbd::clamp(1 + sum, 0.0f, film_tuning::most_load);
    const float first = (lacking.first - passed_on.first) / load - centre[0] * sum,
                second = (lacking.second - passed_on.second) / load - centre[1] * sum;
    const float inverse = 1 / pbd::max(spread[0] * spread[1] - spread[2] * spread[2], 1e-30f);
    const float a = inverse * (spread[1] * first - spread[2] * second),
                b = inverse * (spread[0] * second - spread[2] * first);
    const float tilt = fabsf(a) * sqrtf(spread[0]) + fabsf(b) * sqrtf(spread[1]);
    const float part = pbd::min(1.0f, film_tuning::most_tilt * upright / pbd::max(tilt, 1e-30f));
    slope[0] = part * a;
    slope[1] = part * b;
  }
};

/// The impulse of a triangle's film before it is scaled, N·s.
MENISCUS_HD inline Vec3 film_impulse(const FilmTriangle& t, const Gap& gap, const Pose& pose,
                                     View<const float> pressure, float dt) {
  return -dt * mean_pressure(t, pressure) * gap.film * rotate(pose.rotation, t.area);
}

/// Sums what the films of other bodies exert on a body beyond their pressure.
struct AddPassedOn {
  Surfaces surfaces;
  ShapeSet set;
  View<const Gap> gaps;
  View<const float> pressure;
  View<const Balance> balance;
  WorldAxes world_axes;
  float dt;
  View<UpwardImpulse> passed_on;  ///< by body

  MENISCUS_HD void operator()(uint32_t n) const {
    const FilmTriangle& t = surfaces.triangles[n];
    const Gap& gap = gaps[n];
    if (!(gap.film > 0) || set.shapes[gap.shape].body == pbd::no_index) return;
    const uint32_t other = set.shapes[gap.shape].body;
    const Pose& pose = surfaces.proxies[t.body].pose;
    const LevelAxes& axes = world_axes.of(t.body);
    const Vec3 impulse = film_impulse(t, gap, pose, pressure, dt), x = to_world(pose, t.centre);
    if (!is_finite(impulse)) return;
    const float beyond = (1 - balance[t.body].upright_at(axes, x - pose.position)) * dot(impulse, axes.up);
    passed_on[other].add(axes, beyond, x - surfaces.proxies[other].pose.position);
  }
};

/// Lets each film bear what lacks on its body.
struct BalanceFilms {
  View<UpwardImpulse> passed_on;
  float dt;
  View<Balance> balance;

  MENISCUS_HD void operator()(uint32_t b) const {
    balance[b].find(per_time(passed_on[b], dt));
    passed_on[b] = {0, 0, 0};
  }
};

}  // namespace meniscus::collision::film_kernels
