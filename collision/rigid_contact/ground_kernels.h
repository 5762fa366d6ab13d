// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernel that finds contacts of parts with grounds.
#pragma once

#include "collision/rigid_contact/contact_kernels.h"
#include "collision/rigid_contact/touch_ground.h"

namespace meniscus::collision::rigid_contact_kernels {

/// Pairs with a ground. Such a pair has most_ground_normals entries, one after the other, for as many
/// manifolds. The thread of the first one fills all.
struct TouchGroundPairs {
  PairContacts contacts;
  HullTable hulls;
  GroundTable grounds;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (!contacts.has(k, ConvexKind::ground)) return;
    const PartPair pair = contacts.pairs[k];
    if (k > 0 && contacts.pairs[k - 1].a == pair.a && contacts.pairs[k - 1].b == pair.b) return;
    const View<const PlacedPart> placed = contacts.search.placed;
    const bool turned = contacts.search.parts[pair.a].shape.kind == ConvexKind::ground;
    const uint32_t a = turned ? pair.b : pair.a, b = turned ? pair.a : pair.b;
    const Convex &part = contacts.search.parts[a].shape, &surface = contacts.search.parts[b].shape;
    const Pose& frame = placed[b].pose;
    const Pose at = inverse(frame) * placed[a].pose;
    GroundManifolds found;
    touch_ground(hulls, at, part, extents_of(part, at.rotation), grounds.of(surface.table),
                 contacts.search.reach_of(a, b), found);
    for (uint32_t i = 0; i < most_ground_normals; ++i) {
      FoundContact c{pair.a, pair.b, {}, {}, {}};
      if (i < found.count()) c.manifold = placed_in(frame, found[i], turned ? -1.0f : 1.0f);
      contacts.store(k + i, c);
    }
  }

  MENISCUS_HD static Manifold placed_in(const Pose& frame, const Manifold& local, float sign) {
    Manifold m = local;
    m.normal = sign * rotate(frame.rotation, local.normal);
    for (uint32_t p = 0; p < m.count; ++p) m.points[p].position = to_world(frame, local.points[p].position);
    return m;
  }
};

}  // namespace meniscus::collision::rigid_contact_kernels
