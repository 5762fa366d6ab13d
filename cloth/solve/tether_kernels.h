// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of tethers, and of the reactions at held vertices.
#pragma once

#include "cloth/build/constraints.h"
#include "cloth/solve/vertex_state.h"
#include "pbd/device/side_by_side.h"

namespace meniscus::cloth::tether_kernels {

using pbd::gather;
using pbd::scatter;
using pbd::square_root;

/// Tethers by XPBD, with one departure: a pull given earlier in the substep is not reduced again.
struct ProjectTethers {
  View<const Tether> tethers;
  View<Vec4> pull;  ///< kg·m, at each anchor so far in the substep; w: λ
  VertexState vertices;
  bool starts;

  template <class D>
  MENISCUS_HD void run(const pbd::SideBySide<D>& together) const {
    using Real = typename D::Real;
    using Vector = pbd::Vec3Of<Real>;
    const auto at = together.index();
    pbd::Places<D> vertex, anchor;
    for (uint32_t lane = 0; lane < D::lane_count; ++lane) {
      const Tether& t = tethers[together.items.at[lane]];
      vertex.at[lane] = t.vertex;
      anchor.at[lane] = t.anchor;
    }
    const auto of_each = [&](float Tether::*what) {
      return pbd::by_lane<D>([&](uint32_t lane) { return tethers[together.items.at[lane]].*what; });
    };
    const Real zero(0), square(vertices.inverse_dt * vertices.inverse_dt);
    const Real longest = of_each(&Tether::length);
    const View<Vec4> x = vertices.particles.position.from(vertices.particles.sorted),
                     accumulated_delta = vertices.particles.accumulated_delta.from(vertices.particles.sorted);
    const pbd::Vec4Of<Real> end = gather(x, vertex.index());
    const Vector d = end.xyz() - gather(x, anchor.index()).xyz();
    const Real l = square_root(dot(d, d)), w = end.w, self = w * of_each(&Tether::self_mass);
    const Real loaded = select_less(zero, self, select_less(self, Real(1), self, Real(1)), Real(1));
    const Real soft = square * loaded * of_each(&Tether::compliance);
    const pbd::Vec4Of<Real> before = starts ? pbd::Vec4Of<Real>{zero, zero, zero, zero} : gather(pull, at);
    const Real lacks = l - longest - soft * before.w;
    const uint32_t taut = less_mask(zero, lacks) & less_mask(zero, w) & together.mask();
    if (taut == 0 && !starts) return;
    const Real step = select_less(zero, lacks, select_less(zero, w, lacks / (w + soft), zero), zero);
    const Vector positional_impulse = select_less(zero, step, step / l, zero) * d;
    scatter(pull, at,
            {before.x + positional_impulse.x, before.y + positional_impulse.y,
             before.z + positional_impulse.z, before.w + step},
            together.mask());
    if (taut == 0) return;
    const auto moved_by = [&](const pbd::Vec4Of<Real>& v) {
      return pbd::Vec4Of<Real>{v.x - w * positional_impulse.x, v.y - w * positional_impulse.y,
                               v.z - w * positional_impulse.z, v.w};
    };
    scatter(x, vertex.index(), moved_by(end), taut);
    scatter(accumulated_delta, vertex.index(), moved_by(gather(accumulated_delta, vertex.index())), taut);
  }
};

/// Adds the pulls at held vertices to the reactions of a step.
struct NoteReactions {
  View<const uint32_t> held;
  View<const uint32_t> tether_start;  ///< the first tether of each held vertex; then the number of tethers
  View<const Vec4> pull;
  VertexState vertices;
  View<Vec4> reaction;  ///< N·s

  MENISCUS_HD void operator()(uint32_t k) const {
    Vec3 sum = vertices.particles.accumulated_delta[vertices.particles.sorted + held[k]].xyz();
    for (uint32_t t = tether_start[k]; t < tether_start[k + 1]; ++t) sum += pull[t].xyz();
    reaction[k] = pbd::with_w(reaction[k].xyz() + vertices.inverse_dt * sum, 0);
  }
};

}  // namespace meniscus::cloth::tether_kernels
