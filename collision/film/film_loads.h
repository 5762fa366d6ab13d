// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels that load both faces of films.
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

  MENISCUS_HD static int64_t whole(float x) {
    constexpr double most = 0x1p61;
    const double units = double{x} * (1 / film_tuning::unit);
    return static_cast<int64_t>(units > most ? most : units < -most ? -most : units);
  }
  MENISCUS_HD void add(Vec3 force, Vec3 torque) {
    const float parts[] = {force.x, force.y, force.z, torque.x, torque.y, torque.z};
    for (int k = 0; k < 6; ++k) pbd::atomic_add(part[k], whole(parts[k]));
  }
  MENISCUS_HD float at(int k) const {
    return static_cast<float>(static_cast<double>(part[k]) * film_tuning::unit);
  }
};

/// Sums how hard particles press bodies across gaps that have a film. Such a particle touches both faces.
struct AddPushes {
  pbd::ContactView contacts;
  View<const pbd::Vec4> position;
  View<const pbd::Phase> phase;
  uint32_t sorted;
  View<const uint32_t> has_film;
  Lengths lengths;
  float inverse_dt;
  View<int64_t> pushes;  ///< by body: N·s, in film_tuning::unit

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n >= contacts.total()) return;
    const pbd::Contact& c = contacts.contacts[n];
    const uint32_t i = contacts.particle[n];
    if (c.body >= has_film.count || !has_film[c.body] || i >= sorted || pbd::is_grain(phase[i])) return;
    const Vec3 x = position[i].xyz(), push = -inverse_dt * multiplier_sum(c);
    float most = 0;
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      const pbd::Contact& other = contacts.contacts[k];
      if (k == n || other.body == c.body) continue;
      const float gap = plane_distance(c, x) + plane_distance(other, x);
      most =
          pbd::max(most, lengths.film_between(gap, -dot(c.normal, other.normal)) * dot(push, other.normal));
    }
    if (most > 0) pbd::atomic_add(pushes[c.body], WholeImpulse::whole(most));
  }
};

/// A patch of a fixed shape whose load is measured.
struct LoadProbe {
  uint32_t shape;  ///< Shape::owner
  Aabb patch;
};

/// Adds the impulse of the film's pressure to both faces.
struct AddLoads {
  Surfaces surfaces;
  ShapeSet set;
  View<const Gap> gaps;
  View<const float> pressure;  ///< by vertex
  View<const float> part;      ///< by body: of the pressure, what particles do not exert
  View<const LoadProbe> probes;
  float dt;
  View<WholeImpulse> bodies, probe_sums;

  MENISCUS_HD void operator()(uint32_t n) const {
    const FilmTriangle& t = surfaces.triangles[n];
    const Gap& gap = gaps[n];
    if (!(gap.film > 0) || !(part[t.body] > 0)) return;
    const float mean = part[t.body] * mean_pressure(t, pressure);
    const BodyProxy& body = surfaces.proxies[t.body];
    const Vec3 impulse = -dt * mean * gap.film * rotate(body.pose.rotation, t.area);
    if (!is_finite(impulse)) return;  // the step's end finds what is not finite
    const Vec3 x = to_world(body.pose, t.centre);
    bodies[t.body].add(impulse, cross(x - body.pose.position, impulse));
    const Shape& other = set.shapes[gap.shape];
    if (other.body != pbd::no_index)
      return bodies[other.body].add(-impulse, cross(surfaces.proxies[other.body].pose.position - x, impulse));
    for (uint32_t k = 0; k < probes.count; ++k) {
      if (probes[k].shape == other.owner && inside(probes[k].patch, x - gap.distance * gap.normal))
        probe_sums[k].add(-impulse, {0, 0, 0});
    }
  }
};

/// Writes the sums of each body.
struct ReadLoads {
  View<const WholeImpulse> sums;
  View<RigidImpulse> impulses;

  MENISCUS_HD void operator()(uint32_t b) const {
    const WholeImpulse& s = sums[b];
    impulses[b] = {{s.at(0), s.at(1), s.at(2)}, {s.at(3), s.at(4), s.at(5)}};
  }
};

}  // namespace meniscus::collision::film_kernels
