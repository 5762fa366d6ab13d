// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cloth/constraints.h"
#include "cloth/vertex_state.h"

namespace meniscus::cloth::tether_kernels {

struct ProjectTethers {
  View<const Tether> tethers;
  View<Vec4> pull;  ///< kg·m, on each anchor so far in the substep
  VertexState vertices;
  bool starts;

  MENISCUS_HD void operator()(uint32_t k) const {
    const Tether t = tethers[k];
    const Vertex vertex = vertices.at(t.vertex);
    const Vec4 x = vertex.x;
    const Vec3 d = x.xyz() - vertices.position(t.anchor).xyz();
    const Vec3 before = starts ? Vec3{0, 0, 0} : pull[k].xyz();
    const float l = length(d);
    if (l <= t.length || x.w == 0) {
      if (starts) pull[k] = {0, 0, 0, 0};
      return;
    }
    const Vec3 impulse = (1 - t.length / l) / x.w * d;
    pull[k] = pbd::with_w(before + impulse, 0);
    vertices.push(t.vertex, vertex, -impulse);
  }
};

/// What has pulled at vertices that nothing moves, over a step.
struct NoteReactions {
  View<const uint32_t> held;
  View<const uint32_t> tether_start;  ///< of each held vertex its first tether, and the number of tethers
  View<const Vec4> pull;
  VertexState vertices;
  View<Vec4> reaction;  ///< N·s

  MENISCUS_HD void operator()(uint32_t k) const {
    Vec3 sum = vertices.particles.moved[vertices.particles.sorted + held[k]].xyz();
    for (uint32_t t = tether_start[k]; t < tether_start[k + 1]; ++t) sum += pull[t].xyz();
    reaction[k] = pbd::with_w(reaction[k].xyz() + vertices.inverse_dt * sum, 0);
  }
};

}  // namespace meniscus::cloth::tether_kernels
