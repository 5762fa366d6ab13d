// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels that load both faces of films.
#pragma once

#include "collision/film/film_balance.h"

namespace meniscus::collision::film_kernels {

/// A patch of a fixed shape whose load is measured.
struct LoadProbe {
  uint32_t shape;  ///< Shape::owner
  Aabb patch;
  Vec3 point;  ///< that torque is about
};

/// Adds the impulse of the film's pressure to both faces.
struct AddLoads {
  Surfaces surfaces;
  ShapeSet set;
  View<const Gap> gaps;
  View<const float> pressure;  ///< by vertex
  View<const Balance> balance;
  View<const LoadProbe> probes;
  WorldAxes world_axes;
  float dt;
  View<WholeImpulse> bodies, probe_sums;

  MENISCUS_HD void operator()(uint32_t n) const {
    const FilmTriangle& t = surfaces.triangles[n];
    const Gap& gap = gaps[n];
    if (!(gap.film > 0)) return;
    const BodyProxy& body = surfaces.proxies[t.body];
    const LevelAxes& axes = world_axes.of(t.body);
    const Vec3 whole = film_impulse(t, gap, body.pose, pressure, dt), x = to_world(body.pose, t.centre),
               arm = x - body.pose.position;
    const Balance& part = balance[t.body];
    const Vec3 impulse =
        part.level * whole + (part.upright_at(axes, arm) - part.level) * dot(whole, axes.up) * axes.up;
    if (!is_finite(impulse)) return;  // the step's end finds what is not finite
    bodies[t.body].add(impulse, cross(arm, impulse));
    const Shape& other = set.shapes[gap.shape];
    if (other.body != pbd::no_index)
      return bodies[other.body].add(-impulse, cross(surfaces.proxies[other.body].pose.position - x, impulse));
    const Vec3 at = x - gap.distance * gap.normal;
    for (uint32_t k = 0; k < probes.count; ++k) {
      if (probes[k].shape == other.owner && inside(probes[k].patch, at))
        probe_sums[k].add(-impulse, cross(probes[k].point - at, impulse));
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
