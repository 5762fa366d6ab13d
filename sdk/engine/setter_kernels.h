// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels that give particles positions and velocities from outside.
#pragma once

#include "pbd/particles.h"

namespace meniscus::engine_kernels {

/// Values for particles by slot; the slots ascend. Each particle searches them for its own.
struct SlotValues {
  pbd::View<const uint32_t> slots;
  pbd::View<const Vec3> values;

  MENISCUS_HD const Vec3* find(uint32_t slot) const {
    uint32_t low = 0, high = slots.count;
    while (low < high) {
      const uint32_t middle = (low + high) / 2;
      if (slots[middle] < slot)
        low = middle + 1;
      else
        high = middle;
    }
    return low < slots.count && slots[low] == slot ? &values[low] : nullptr;
  }
};

/// Moves particles. Of their phase the kind and the group remain, as in new particles.
struct PlaceParticles {
  pbd::View<pbd::Vec4> position;
  pbd::View<pbd::Phase> phase;
  pbd::View<const uint32_t> slot;
  SlotValues to;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3* place = to.find(slot[i]);
    if (!place) return;
    position[i] = pbd::with_w(*place, position[i].w);
    phase[i] &= pbd::phase_group_mask | pbd::phase_fluid | pbd::phase_grain;
  }
};

struct SetVelocities {
  pbd::View<pbd::Vec4> velocity;
  pbd::View<const uint32_t> slot;
  SlotValues to;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3* value = to.find(slot[i]);
    if (value) velocity[i] = pbd::with_w(*value, velocity[i].w);
  }
};

}  // namespace meniscus::engine_kernels
