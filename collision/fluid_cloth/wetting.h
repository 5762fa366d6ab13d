// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the particles that touch absorbent cloth.
#pragma once

#include "collision/fluid_cloth/passing.h"

namespace meniscus::collision::fluid_cloth_kernels {

/// Lists the nearest absorbent contact of each particle, in no order.
struct ListWetting {
  NearList near;
  View<const pbd::Contact> contacts;
  View<const FluidClothPiece> pieces;
  View<const Vec4> position;
  View<const uint32_t> slot;
  View<WettingTouch> found;
  View<uint32_t> counter;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= near.count()) return;
    const uint32_t i = near.particle[k];
    uint32_t vertex = no_index;
    float least = 1e30f;
    for (uint32_t n = 0; n < most_touches; ++n) {
      const FluidClothContact& t = near.touches[most_touches * k + n];
      if (!is_used(t) || t.contact >= contacts.count || !pieces[t.piece].absorbs) continue;
      const pbd::Contact& c = contacts[t.contact];
      const float distance = plane_distance(c, position[i].xyz());
      if (distance >= clear_of_cloth(c.radius) || distance >= least) continue;
      least = distance;
      vertex = heaviest(t);
    }
    if (vertex != no_index) found[pbd::append(counter[0], 1)] = {slot[i], vertex};
  }

  MENISCUS_HD static uint32_t heaviest(const FluidClothContact& t) {
    uint32_t best = 0;
    for (uint32_t k = 1; k < t.vertices; ++k) best = t.weight[k] > t.weight[best] ? k : best;
    return t.vertex[best];
  }
};

}  // namespace meniscus::collision::fluid_cloth_kernels
