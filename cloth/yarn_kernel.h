// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cloth/tridiagonal.h"
#include "cloth/vertex_state.h"
#include "cloth/yarns.h"

namespace meniscus::cloth {

/// A yarn while it is worked on: of each edge n, and in w the multiplier before; and its row.
struct YarnScratch {
  Vec4 edge[Yarn::most_edges];
  TridiagonalRow rows[2][Yarn::most_edges];
};

/// XPBD for all edges of a yarn at once (the direct solve of Deul et al. 2018, for points): with n the edges'
/// directions and w inverse masses, row k of (J W Jᵀ + A) Δλ = −C − A λ is
///
///   −w_k (n_k₋₁·n_k) Δλ_k₋₁ + (w_k + w_k₊₁ + α̃) Δλ_k − w_k₊₁ (n_k·n_k₊₁) Δλ_k₊₁ = −C_k − α̃ λ_k
///
/// with damping as in xpbd_step. What is pressed together is lengthened in full, as what is stretched is
/// shortened: of small motions to and fro, either alone would be left.
struct SolveYarns {
  using Scratch = YarnScratch;

  /// Added to the diagonal, as a share of w_k + w_k₊₁: directions stay as they are while lengths are solved
  /// for, so that what goes far along a yarn would overshoot to the sides.
  static constexpr float guard = 0.003f;

  View<const Yarn> yarns;
  View<const EdgeConstraint> edges;
  View<Vec4> multiplier;  ///< kg·m: λ n, and λ
  VertexState all;
  float share;     ///< of the multiplier that there is
  uint32_t first;  ///< yarn of the layer

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t number) const {
    const Yarn yarn = yarns[first + number];
    group.for_each(yarn.count, [&](uint32_t k) { linearize(scratch, yarn.first + k, k); });
    group.for_each(yarn.count, [&](uint32_t k) { couple(scratch, yarn.count, k); });
    const TridiagonalRow* solved = solve_tridiagonal(group, scratch.rows[0], scratch.rows[1], yarn.count);
    group.for_each(yarn.count + 1, [&](uint32_t k) { move(scratch, solved, yarn, k); });
  }

 private:
  /// The row, but for the angles to the edges before and after.
  MENISCUS_HD void linearize(Scratch& scratch, uint32_t edge, uint32_t k) const {
    const EdgeConstraint e = load(edges, edge);
    const Vec4 a = all.position(e.a), b = all.position(e.b);
    const float before = share * multiplier[edge].w;
    const Vec3 d = b.xyz() - a.xyz();
    const float l = length(d), weight = a.w + b.w;
    const float compliance = e.compliance * all.inverse_dt * all.inverse_dt;
    if (weight + compliance == 0 || l < 1e-12f) {
      scratch.edge[k] = {0, 0, 0, before};
      scratch.rows[0][k] = {0, 1, 0, 0};
      return;
    }
    const Vec3 n = 1 / l * d;
    const float damping = all.stretch_damping(e.a);
    float rate = 0, gamma = 0;
    if (damping > 0) {
      rate = dot(n, d - (all.previous(e.b).xyz() - all.previous(e.a).xyz()));
      gamma = damping * compliance / (compliance + weight);
    }
    scratch.edge[k] = pbd::with_w(n, before);
    scratch.rows[0][k] = {-(1 + gamma) * a.w, (1 + gamma + guard) * weight + compliance, -(1 + gamma) * b.w,
                          e.rest_length - l - compliance * before - gamma * rate};
  }

  MENISCUS_HD static void couple(Scratch& scratch, uint32_t count, uint32_t k) {
    const Vec3 n = scratch.edge[k].xyz();
    TridiagonalRow& row = scratch.rows[0][k];
    row.lower = k > 0 ? row.lower * dot(n, scratch.edge[k - 1].xyz()) : 0;
    row.upper = k + 1 < count ? row.upper * dot(n, scratch.edge[k + 1].xyz()) : 0;
  }

  /// Moves vertex k, and notes the multiplier of the edge that begins there.
  MENISCUS_HD void move(const Scratch& scratch, const TridiagonalRow* solved, const Yarn& yarn,
                        uint32_t k) const {
    const bool begins = k < yarn.count;
    const uint32_t edge = yarn.first + (begins ? k : k - 1);
    const EdgeConstraint e = load(edges, edge);
    Vec4 impulse{0, 0, 0, 0};
    if (k > 0) impulse = plus(impulse, solved[k - 1].right, scratch.edge[k - 1]);
    if (begins) {
      const Vec4 n = scratch.edge[k];
      const float step = solved[k].right, now = n.w + step;
      impulse = plus(impulse, -step, n);
      multiplier[edge] = {now * n.x, now * n.y, now * n.z, now};
    }
    impulse.w = 0;
    const uint32_t v = begins ? e.a : e.b;
    all.push(v, all.at(v), 1, impulse);
  }
};

}  // namespace meniscus::cloth
