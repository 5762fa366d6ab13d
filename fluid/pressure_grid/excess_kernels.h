// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How much volume is too much: of each particle, and around each node.
#pragma once

#include "fluid/kernel/density_wall_kernels.h"
#include "fluid/pressure_grid/nodes_kernels.h"

namespace meniscus::fluid::grid_kernels {

/// Too much volume at a particle, of a particle's own volume. What was too much or too little already at the
/// last substep's end is undone at a rate, not at once: short steps would make great speeds of small errors.
struct ExcessOf {
  View<const density_kernels::Multiplier> last;
  float kept;  ///< share of the old error that stays

  MENISCUS_HD float operator()(uint32_t i, float constraint) const {
    // Nothing holds up what closes a gap, until it is closed.
    const float change = pbd::min(constraint - kept * last[i].relieved, pbd::max(constraint, 0.0f));
    // Where the density lacks by little, the lattice is loose there, and the sign counts; where it lacks by
    // much there is a surface.
    return change * pbd::clamp(5 * constraint + 1.5f, 0.0f, 1.0f);
  }
};

struct Excess {
  Kernel kernel;
  Space space;
  pbd::NeighbourView neighbours;
  View<const uint32_t> contact_start;
  View<const Vec4> position;
  View<const pbd::Phase> phase;
  ExcessOf excess_of;
  View<Found> found;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    if (contact_start[i] != contact_start[i + 1]) return;
    const float value = density_kernels::density_constraint<D>(kernel, position, neighbours, i).value;
    if (!D::leads()) return;
    const float excess = pbd::is_grain(phase[i]) ? 0.0f : excess_of(i, value);
    found[i] = pbd::with_w(space.part(position[i].xyz(), i), excess);
  }
};

struct ExcessAtWalls {
  Kernel kernel;
  Space space;
  pbd::NeighbourView neighbours;
  ContactView contacts;
  View<const Vec4> position;
  View<const pbd::Phase> phase;
  ExcessOf excess_of;
  View<Found> found;

  template <class D>
  MENISCUS_HD void run(uint32_t k) const {
    const uint32_t i = contacts.touching_particle(k);
    if (i == pbd::no_index) return;
    const float value =
        density_kernels::density_constraint_at_walls<D, false>(kernel, position, neighbours, contacts, i)
            .value;
    if (!D::leads()) return;
    const float excess = pbd::is_grain(phase[i]) ? 0.0f : excess_of(i, value);
    found[i] = pbd::with_w(space.part(position[i].xyz(), i), excess);
  }
};

/// How much volume around a node is too much, m³.
struct GatherExcess {
  Space space;
  View<const uint32_t> flags;
  View<const Found> found;
  float volume;  ///< m³, of a particle
  float least;   ///< m³: what lacks more is no longer noise, and for gravity to close
  View<float> right;

  MENISCUS_HD void operator()(uint32_t node) const {
    float sum = 0;
    if (flags[node] & node_fluid) {
      for_each_around(space, node, found, AllCells{},
                      [&](uint32_t i, Vec3 away) { sum += found[i].w * node_weight(away); });
    }
    right[node] = pbd::max(volume * sum, least);
  }
};

}  // namespace meniscus::fluid::grid_kernels
