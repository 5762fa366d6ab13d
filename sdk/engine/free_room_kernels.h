// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels that mark the arrivals which particles or solids block.
#pragma once

#include "collision/contact/opening.h"
#include "pbd/device/base/atomics.h"
#include "sdk/engine/engine_kernels.h"
#include "sdk/engine/point_table.h"

namespace meniscus::free_room_kernels {

using pbd::View;

/// Runs over particles and vertices, and marks the arrivals that are too near to one. An arrival that has
/// waited gives its velocity to such a particle, as if that had left the opening. If there are several, the
/// first one does.
struct BlockByParticles {
  View<const pbd::Vec4> position;
  View<pbd::Vec4> velocity;
  View<pbd::Phase> phase;
  uint32_t sorted;
  View<const Arrival> arrivals;
  PointTableView table;
  Aabb box;  // holds all arrivals and what may be near them
  View<uint32_t> blocked;
  float apart;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 p = position[i].xyz();
    if (!inside(box, p)) return;
    uint32_t driver = pbd::no_index;
    table.for_each_near(p, [&](uint32_t k) {
      if (length(arrivals[k].to - p) >= apart) return;
      pbd::atomic_max(blocked[k], 1);
      if (arrivals[k].waits && k < driver) driver = k;
    });
    if (driver == pbd::no_index || i >= sorted || (phase[i] & pbd::phase_piston)) return;
    velocity[i] = pbd::with_w(arrivals[driver].velocity, velocity[i].w);
    if (pbd::held_steps(phase[i]) == 0) phase[i] += pbd::held_for(1);
  }
};

/// Visits points near arrival i, and notes whether an earlier arrival with room is too near. The host runs
/// it. A lambda of the host cannot be passed to a function for both devices.
struct FindEarlier {
  const Vec3* points;
  const uint8_t* has_room;
  uint32_t i;
  float apart;
  bool& near;

  MENISCUS_HD void operator()(uint32_t j) const {
    if (j < i && has_room[j] && length(points[j] - points[i]) < apart) near = true;
  }
};

/// Runs over arrivals, and marks those with a solid in their way. It marches from the opening in steps so
/// short that no solid is missed.
struct BlockBySolids {
  collision::ShapeSet set;
  View<const Arrival> arrivals;
  View<uint32_t> blocked;
  float clearance, reach, radius;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Arrival& a = arrivals[i];
    if (a.in_duct) return;
    const Vec3 path = a.to - a.from;
    const float whole = length(path);
    for (float along = 0;;) {
      const float nearest = distance(a.from + (whole > 0 ? along / whole : 0) * path, a.filter);
      if (nearest < clearance) return pbd::atomic_max(blocked[i], 1);
      if (along >= whole) return;
      along = pbd::min(whole, along + pbd::max(nearest - clearance, clearance));
    }
  }

  MENISCUS_HD float distance(Vec3 p, const CollisionFilter& filter) const {
    return engine_kernels::nearest_solid(set, filter, p, reach, [&](const collision::Shape& shape) {
      return shape.kind == collision::ShapeKind::plane && left_through_opening(set, shape, {p, p}, radius);
    });
  }
};

}  // namespace meniscus::free_room_kernels
