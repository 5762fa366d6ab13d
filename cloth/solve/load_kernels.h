// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the pieces of cloth that are loaded by bodies or fluid. Edges of loaded pieces start without
// multipliers, since the last ones do not fit the present load.
#pragma once

#include "cloth/solve/vertex_state.h"
#include "pbd/contacts.h"

namespace meniscus::cloth::load_kernels {

/// The load of a piece; fluid, if bodies load it as well. A fresh piece has no last multipliers to start
/// from, whatever loads it.
enum Load : uint32_t { nothing, bodies, fluid, fresh };

/// Marks the piece of each vertex that is near a movable body, or attached to one. Contacts at a distance
/// count as well. Otherwise a piece that a heavy body left for one substep would start from its earlier
/// pulls.
struct NoteBodyLoads {
  pbd::ContactView contacts;
  VertexState vertices;
  uint32_t vertex_count;
  View<uint32_t> loaded;  ///< by piece, see Load

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

/// Marks likewise the piece of each vertex that is near fluid. Fluid changes the effective masses of
/// vertices. Multipliers found with other masses threw vertices about.
struct NoteFluidLoads {
  View<const uint32_t> near;  ///< see Substep::fluid_near
  VertexState vertices;
  View<uint32_t> loaded;  ///< by piece, see Load

  MENISCUS_HD void operator()(uint32_t v) const {
    if (near[v] != near[v + 1]) pbd::atomic_max(loaded[vertices.piece_number(v)], fluid);
  }
};

/// What a world of a batch has of its own, beside arrays.
struct WorldClock {
  double time;        ///< s
  uint32_t has_last;  ///< 1: a substep has left multipliers
  uint32_t unused = 0;
};

/// Marks the pieces of worlds that have no last multipliers.
struct MarkFresh {
  View<const WorldClock> clocks;
  uint32_t pieces;  ///< of a world
  View<uint32_t> loaded;

  MENISCUS_HD void operator()(uint32_t p) const {
    if (!clocks[p / pieces].has_last) loaded[p] = fresh;
  }
};

/// Ends a substep, by world.
struct AdvanceClocks {
  View<WorldClock> clocks;
  float dt;

  MENISCUS_HD void operator()(uint32_t w) const {
    clocks[w].time += static_cast<double>(dt);
    clocks[w].has_last = 1;
  }
};

/// Clears the multipliers of edges outside chains in loaded pieces.
struct Forget {
  View<const uint32_t> edge_end_start, edge_ends;  ///< the ends of edges at each vertex: 2 · edge + end
  View<const uint32_t> loaded;
  VertexState vertices;
  View<Vec4> multiplier;

  MENISCUS_HD void operator()(uint32_t v) const {
    const uint32_t load = loaded[vertices.piece_number(v)];
    if (load == nothing || load == fresh) return;
    for (uint32_t k = edge_end_start[v]; k < edge_end_start[v + 1]; ++k) {
      if (edge_ends[k] % 2 == 0) multiplier[edge_ends[k] / 2] = {0, 0, 0, 0};
    }
  }
};

}  // namespace meniscus::cloth::load_kernels
