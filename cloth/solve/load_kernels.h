// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Which pieces of cloth bear bodies or fluid: their edges start from no multipliers, as these do not fit what
// lies there now.
#pragma once

#include "cloth/solve/vertex_state.h"
#include "pbd/contacts.h"

namespace meniscus::cloth::load_kernels {

/// What a piece bears; where it is both, fluid.
enum Load : uint32_t { nothing, bodies, fluid };

/// Of each vertex that is near a body that gives way, or attached to such a one, the piece. Where only
/// touches counted, one that a heavy body has left for a substep would start from what it pulled with before.
struct NoteBodyLoads {
  pbd::ContactView contacts;
  VertexState vertices;
  uint32_t vertex_count;
  View<uint32_t> loaded;  ///< by piece, see Bearing

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t i = contacts.touching_particle(n), v = i - vertices.particles.sorted;
    if (i == pbd::no_index || i < vertices.particles.sorted || v >= vertex_count) return;
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      if (is_of_body(contacts.contacts[k])) pbd::atomic_max(loaded[vertices.piece_number(v)], bodies);
    }
  }
  MENISCUS_HD static bool is_of_body(const pbd::Contact& c) {
    return c.body < pbd::on_cloth && c.body_inverse_mass > 0;
  }
};

/// Likewise of each vertex that fluid is near. Under it vertices have other masses than multipliers were
/// found with: started from these they were thrown about.
struct NoteFluidLoads {
  View<const uint32_t> near;  ///< see Substep::fluid_near
  VertexState vertices;
  View<uint32_t> loaded;  ///< by piece, see Bearing

  MENISCUS_HD void operator()(uint32_t v) const {
    if (near[v] != near[v + 1]) pbd::atomic_max(loaded[vertices.piece_number(v)], fluid);
  }
};

/// What edges outside chains have pushed with, where their piece bears something.
struct Forget {
  View<const uint32_t> fan_start, fan;  ///< of each vertex its edges' ends: 2 · edge + end
  View<const uint32_t> loaded;
  VertexState vertices;
  View<Vec4> multiplier;

  MENISCUS_HD void operator()(uint32_t v) const {
    if (loaded[vertices.piece_number(v)] == nothing) return;
    for (uint32_t k = fan_start[v]; k < fan_start[v + 1]; ++k) {
      if (fan[k] % 2 == 0) multiplier[fan[k] / 2] = {0, 0, 0, 0};
    }
  }
};

}  // namespace meniscus::cloth::load_kernels
