// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The excess volume: of each particle, and around each node.
#pragma once

#include "fluid/kernel/density_wall_kernels.h"
#include "fluid/pressure_grid/nodes_kernels.h"
#include "fluid/pressure_grid/tuning.h"

namespace meniscus::fluid::grid_kernels {

/// The excess volume at a particle, relative to a particle's volume. The excess or lack that existed at the
/// end of the last substep is corrected at a rate, not at once. Otherwise short steps would turn small errors
/// into high speeds.
struct ExcessOf {
  View<const density_kernels::Multiplier> last;
  float kept;                 ///< the fraction of the old error that stays
  View<const float> allowed;  ///< see Advancing

  MENISCUS_HD float operator()(uint32_t i, float constraint) const {
    if (allowed.count) constraint -= allowed[i];
    // A motion that closes a gap is not resisted until the gap is closed.
    const float before = last[i].relieved, old = before < density_kernels::unmeasured ? before : constraint;
    const float change = pbd::min(constraint - kept * old, pbd::max(constraint, 0.0f));
    // A slightly low density is disorder of the lattice, so its sign counts. A very low density is a surface.
    return change *
           pbd::clamp(grid_tuning::disorder_slope * constraint + grid_tuning::disorder_offset, 0.0f, 1.0f);
  }
};

template <class K>
struct Excess {
  K kernel;
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

template <class K>
struct ExcessAtWalls {
  K kernel;
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
    const float value = density_kernels::density_constraint_at_walls<D, density_kernels::WallMotion::none>(
                            kernel, position, neighbours, contacts, i)
                            .value;
    if (!D::leads()) return;
    const float excess = pbd::is_grain(phase[i]) ? 0.0f : excess_of(i, value);
    found[i] = pbd::with_w(space.part(position[i].xyz(), i), excess);
  }
};

/// The excess volume around a node, m³.
struct GatherExcess {
  Space space;
  View<const uint32_t> flags;
  View<const Found> found;
  float volume;  ///< m³, of a particle
  float least;   ///< m³: a greater lack is not noise, and is left to gravity
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
