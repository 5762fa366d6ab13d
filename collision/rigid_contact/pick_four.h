// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Chooses the points of a manifold among the corners of a contact's area.
#pragma once

#include "collision/rigid_contact/manifold.h"
#include "collision/rigid_contact/tuning.h"
#include "pbd/math/tangents.h"

namespace meniscus::collision {

/// A corner of the area of a contact.
struct ContactCorner {
  Vec3 at;         ///< m
  float distance;  ///< m, along the normal
  uint32_t feature;
};

/// The corner that is furthest by a measure, the first one of equals.
struct FurthestCorner {
  ContactCorner corner{{0, 0, 0}, 0, 0};
  float most = -1e30f;

  MENISCUS_HD void offer(const ContactCorner& c, float measure) {
    if (measure > most) {
      most = measure;
      corner = c;
    }
  }
};

/// Calls keep(corner) for four corners at most: a lowest one, the furthest from it, and those that span the
/// most area to both sides. each(visit) gives all corners, and is called several times. So a kernel has no
/// list of them. `scale` (m) is the least half extent of the parts.
template <class Each, class Keep>
MENISCUS_HD void pick_four(const Each& each, Vec3 normal, float scale, const Keep& keep) {
  uint32_t count = 0;
  float lowest = 1e30f;
  each([&](const ContactCorner& c) {
    ++count;
    lowest = pbd::min(lowest, c.distance);
  });
  if (count <= most_manifold_points) return each(keep);
  const Tangents t(normal);
  // Askew, so that no two corners of a symmetric area are equally far.
  const Vec3 askew = t.u + 0.31f * t.v;
  const float level = lowest + rigid_contact_tuning::level * scale;
  FurthestCorner first, second, third, fourth;
  each([&](const ContactCorner& c) {
    if (c.distance <= level) first.offer(c, dot(askew, c.at));
  });
  const Vec3 a = first.corner.at;
  each([&](const ContactCorner& c) { second.offer(c, dot(c.at - a, c.at - a)); });
  const Vec3 side = cross(normal, second.corner.at - a);
  each([&](const ContactCorner& c) {
    third.offer(c, dot(side, c.at - a));
    fourth.offer(c, -dot(side, c.at - a));
  });
  keep(first.corner);
  if (second.most > 0) keep(second.corner);
  const float least = rigid_contact_tuning::parallel * second.most;  // of twice the area
  if (third.most > least) keep(third.corner);
  if (fourth.most > least) keep(fourth.corner);
}

}  // namespace meniscus::collision
