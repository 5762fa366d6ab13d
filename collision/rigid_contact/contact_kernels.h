// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels that find contacts of pairs, and give them what they start from.
#pragma once

#include "collision/rigid_contact/hull_round.h"
#include "collision/rigid_contact/pair_kernels.h"
#include "collision/rigid_contact/touch.h"

namespace meniscus::collision::rigid_contact_kernels {

/// The contact of a pair, with the impulses it starts from.
struct FoundContact {
  uint32_t a, b;  ///< parts
  Manifold manifold;
  float pressure[most_manifold_points];  ///< N
  Vec3 friction[most_manifold_points];   ///< N
};

/// What is kept of a contact for the next step, by the first of its parts.
struct ContactMemory {
  uint32_t b, count;
  Vec3 normal;
  uint32_t feature[most_manifold_points];
  float pressure[most_manifold_points];
  Vec3 friction[most_manifold_points];
  Vec3 position[most_manifold_points];
  float distance[most_manifold_points], impulse[most_manifold_points];
};

/// The parts of a contact if they touch, with `a` the first of them; otherwise no_index.
MENISCUS_HD inline PartPair touching_parts(uint32_t a, const ContactMemory& m) {
  bool touches = false;
  for (uint32_t k = 0; k < m.count; ++k) touches |= m.distance[k] <= 0 || m.impulse[k] > 0;
  return touches ? PartPair{a, m.b} : PartPair{pbd::no_index, pbd::no_index};
}

/// Finds contacts of pairs, and gives them what they start from.
struct PairContacts {
  PairSearch search;
  View<const PartPair> pairs;
  View<const ContactMemory> memory;
  View<const uint32_t> memory_start;
  View<FoundContact> found;
  View<uint32_t> touches;

  MENISCUS_HD bool has(uint32_t k, ConvexKind kind) const {
    return search.parts[pairs[k].a].shape.kind == kind || search.parts[pairs[k].b].shape.kind == kind;
  }

  /// Calls touch(pose_a, a, pose_b, b, reach) for the manifold of a pair.
  template <class Touch>
  MENISCUS_HD void find(uint32_t k, const Touch& touch) const {
    const PartPair pair = pairs[k];
    const View<const ContactPart> parts = search.parts;
    const View<const PlacedPart> placed = search.placed;
    // A plane is only ever the second one.
    const bool turned = parts[pair.a].shape.kind == ConvexKind::plane;
    const uint32_t a = turned ? pair.b : pair.a, b = turned ? pair.a : pair.b;
    FoundContact c{pair.a, pair.b, {}, {}, {}};
    c.manifold = touch(placed[a].pose, parts[a].shape, placed[b].pose, parts[b].shape, search.reach_of(a, b));
    if (turned) c.manifold.normal = -c.manifold.normal;
    store(k, c);
  }

  /// Stores the contact of a pair, with what it starts from.
  MENISCUS_HD void store(uint32_t k, FoundContact c) const {
    remember(c);
    found[k] = c;
    touches[k] = c.manifold.count > 0;
  }

  MENISCUS_HD void remember(FoundContact& c) const {
    for (uint32_t m = memory_start[c.a]; m < memory_start[c.a + 1]; ++m) {
      if (memory[m].b != c.b) continue;
      for (uint32_t k = 0; k < c.manifold.count; ++k) {
        for (uint32_t old = 0; old < memory[m].count; ++old) {
          if (memory[m].feature[old] != c.manifold.points[k].feature) continue;
          c.pressure[k] = memory[m].pressure[old];
          c.friction[k] = memory[m].friction[old];
        }
      }
    }
  }
};

/// Pairs of boxes, round parts and planes.
struct TouchPairs {
  PairContacts contacts;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (contacts.has(k, ConvexKind::hull) || contacts.has(k, ConvexKind::ground)) return;
    contacts.find(k, [](const Pose& a, const Convex& of_a, const Pose& b, const Convex& of_b, float reach) {
      return touch(a, of_a, b, of_b, reach);
    });
  }
};

/// Pairs with a hull.
struct TouchHullPairs {
  PairContacts contacts;
  HullTable hulls;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (!contacts.has(k, ConvexKind::hull) || contacts.has(k, ConvexKind::ground)) return;
    contacts.find(k, [this](const Pose& a, const Convex& of_a, const Pose& b, const Convex& of_b,
                            float reach) { return touch_hull(hulls, a, of_a, b, of_b, reach); });
  }
};

/// Lists the pairs that are in contact.
struct ListContacts {
  View<const uint32_t> touches, place;
  View<uint32_t> contacts;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (touches[k]) contacts[place[k]] = k;
  }
};

/// Where the contacts of each part begin.
struct FindContactStarts {
  View<const uint32_t> pair_start, place;
  View<uint32_t> start;

  MENISCUS_HD void operator()(uint32_t part) const { start[part] = place[pair_start[part]]; }
};

}  // namespace meniscus::collision::rigid_contact_kernels
