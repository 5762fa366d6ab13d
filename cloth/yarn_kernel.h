// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cloth/edge_compliance.h"
#include "cloth/tridiagonal.h"
#include "cloth/vertex_state.h"
#include "cloth/yarns.h"

namespace meniscus::cloth {

/// A yarn while it is worked on: of each edge n, and in w its multiplier; and the rows of two systems, one
/// after the other.
struct YarnScratch {
  using Length = TridiagonalRow<float>;
  using Sideways = TridiagonalRow<Vec3>;

  Vec4 edge[Yarn::most_edges];
  alignas(16) unsigned char rows[2][(Yarn::most_edges + 1) * sizeof(Sideways)];

  template <class Row>
  MENISCUS_HD Row* rows_of(int which) {
    return reinterpret_cast<Row*>(rows[which]);
  }
};

/// XPBD for all edges of a yarn at once (the direct solve of Deul et al. 2018, for points), with the
/// geometric stiffness of what is taut (Tournier et al. 2015): an edge with multiplier λ and length l that
/// turns by Δd across itself pushes with λ Δd/l. Without it a taut yarn flies to the sides wherever λ/(m l)
/// is not small, and a light vertex between heavy ones would seem to give way to any pull.
///
/// 1. Lengths. With n the edges' directions, t that of the yarn at a vertex, and W = w (t tᵀ + s (1 − t tᵀ)),
///    s = 1/(1 + w Σ|λ|/l) with the last λ, row k of (J W Jᵀ + A) Δλ = −C − A λ is
///
///      −n_k₋₁ᵀ W_k n_k Δλ_k₋₁ + (n_kᵀ (W_k + W_k₊₁) n_k + α̃) Δλ_k − n_kᵀ W_k₊₁ n_k₊₁ Δλ_k₊₁ = −C_k − α̃ λ_k
///
///    with damping as in xpbd_step.
/// 2. Ways to the sides, y: (1 + w G) y = w f, with f the part of the vertices' pushes across the yarn and G
///    the Laplacian of |λ|/l. Edges then push with λ n − |λ|/l Δy: in pairs, so that momentum is kept.
///
/// What is pressed together is lengthened in full, as what is stretched is shortened: of small motions to and
/// fro, either alone would be left.
struct SolveYarns {
  using Scratch = YarnScratch;
  using Length = YarnScratch::Length;
  using Sideways = YarnScratch::Sideways;

  /// Added to the diagonal, as a share of w_k + w_k₊₁: what is straight between two places that nothing moves
  /// has no solution.
  static constexpr float guard = 0.0003f;

  View<const Yarn> yarns;
  View<const EdgeConstraint> edges;
  View<Vec4> multiplier;  ///< kg·m: what an edge pushes with, and λ
  VertexState all;
  bool starts;     ///< from none of the last substep's multipliers
  uint32_t first;  ///< yarn of the layer

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t number) const {
    const Yarn yarn = yarns[first + number];
    Length* lengths = scratch.template rows_of<Length>(0);
    group.for_each(yarn.count, [&](uint32_t k) { lengths[k] = linearize(scratch, yarn, k); });
    group.for_each(yarn.count, [&](uint32_t k) { couple(scratch, lengths[k], yarn, k); });
    const Length* steps = solve_tridiagonal(group, lengths, scratch.template rows_of<Length>(1), yarn.count);
    group.for_each(yarn.count, [&](uint32_t k) { scratch.edge[k].w += steps[k].right; });

    Sideways* sideways = scratch.template rows_of<Sideways>(0);
    group.for_each(yarn.count + 1, [&](uint32_t k) { sideways[k] = turn(scratch, yarn, k); });
    const Sideways* ways =
        solve_tridiagonal(group, sideways, scratch.template rows_of<Sideways>(1), yarn.count + 1);
    group.for_each(yarn.count + 1, [&](uint32_t k) { move(scratch, ways, yarn, k); });
    group.for_each(yarn.count, [&](uint32_t k) { note(scratch, ways, yarn, k); });
  }

 private:
  /// Of the yarn at a vertex. Where it folds back, that of both its branches: across them nothing is
  /// shortened.
  MENISCUS_HD static Vec3 direction(Vec3 before, Vec3 after) {
    return normalized_or(dot(before, after) < 0 ? after - before : after + before, {0, 0, 0});
  }

  /// How readily a vertex gives way, 1/kg.
  struct Mobility {
    Vec3 along;
    float w, sideways;

    MENISCUS_HD Mobility(Vec3 before, Vec3 after, float weight, float stiffness)
        : along(direction(before, after)), w(weight), sideways(1 / (1 + weight * stiffness)) {}
    MENISCUS_HD float operator()(Vec3 p, Vec3 q) const {
      return w * ((1 - sideways) * dot(p, along) * dot(q, along) + sideways * dot(p, q));
    }
  };

  MENISCUS_HD uint32_t vertex(const Yarn& yarn, uint32_t k) const {
    return k < yarn.count ? edges[yarn.first + k].a : edges[yarn.first + k - 1].b;
  }
  /// kg, of an edge with a multiplier: how much it resists being turned.
  MENISCUS_HD float stiffness(float lambda, const Yarn& yarn, uint32_t k) const {
    const float rest = edges[yarn.first + k].rest_length;
    return rest > 0 ? fabsf(lambda) / rest : 0;
  }

  /// The row, but for what comes from the mobilities of the ends, whose weights stand beside the diagonal.
  MENISCUS_HD Length linearize(Scratch& scratch, const Yarn& yarn, uint32_t k) const {
    const EdgeConstraint e = load(edges, yarn.first + k);
    const Vec4 a = all.position(e.a), b = all.position(e.b);
    const float before = given(yarn, k).w;
    const Vec3 d = b.xyz() - a.xyz();
    const float l = length(d), weight = a.w + b.w;
    const float error = l - e.rest_length;
    const float compliance = edge_compliance(all, e, error, weight, all.inverse_dt);
    if (weight + compliance == 0 || l < 1e-12f) {
      scratch.edge[k] = {0, 0, 0, before};
      return {0, 1, 0, 0};
    }
    const Vec3 n = 1 / l * d;
    const float damping = all.stretch_damping(e.a);
    float rate = 0, gamma = 0;
    if (damping > 0) {
      rate = dot(n, d - (all.previous(e.b).xyz() - all.previous(e.a).xyz()));
      gamma = damping * compliance / (compliance + weight);
    }
    scratch.edge[k] = pbd::with_w(n, before);
    return {(1 + gamma) * a.w, compliance + guard * weight, (1 + gamma) * b.w,
            -error - compliance * before - gamma * rate};
  }

  MENISCUS_HD void couple(const Scratch& scratch, Length& row, const Yarn& yarn, uint32_t k) const {
    const bool begins = k == 0, ends = k + 1 == yarn.count;
    const Vec3 n = scratch.edge[k].xyz();
    const Vec3 before = begins ? Vec3{0, 0, 0} : scratch.edge[k - 1].xyz();
    const Vec3 after = ends ? Vec3{0, 0, 0} : scratch.edge[k + 1].xyz();
    const float here = last_stiffness(yarn, k);
    const Mobility a(before, n, row.lower, here + (begins ? 0 : last_stiffness(yarn, k - 1)));
    const Mobility b(n, after, row.upper, here + (ends ? 0 : last_stiffness(yarn, k + 1)));
    row.diagonal += a(n, n) + b(n, n);
    row.lower = -a(before, n);
    row.upper = -b(n, after);
  }
  MENISCUS_HD float last_stiffness(const Yarn& yarn, uint32_t k) const {
    return stiffness(multiplier[yarn.first + k].w, yarn, k);
  }

  /// kg·m, and λ: what edge k has pushed its end with.
  MENISCUS_HD Vec4 given(const Yarn& yarn, uint32_t k) const {
    return starts ? Vec4{0, 0, 0, 0} : multiplier[yarn.first + k];
  }
  /// kg·m: what it is to push with beyond that. Where it is taut, the whole is to point as the edge does now;
  /// what is pressed together would be thrown to the sides by that.
  MENISCUS_HD Vec3 step(const Scratch& scratch, const Yarn& yarn, uint32_t k) const {
    const Vec4 edge = scratch.edge[k], before = given(yarn, k);
    return edge.w > 0 ? (edge.w - before.w) * edge.xyz() : edge.w * edge.xyz() - before.xyz();
  }
  /// The same of both edges on vertex k.
  MENISCUS_HD Vec3 steps_on(const Scratch& scratch, const Yarn& yarn, uint32_t k) const {
    Vec3 sum{0, 0, 0};
    if (k > 0) sum += step(scratch, yarn, k - 1);
    if (k < yarn.count) sum += -step(scratch, yarn, k);
    return sum;
  }
  /// The row of vertex k's way to the sides, m.
  MENISCUS_HD Sideways turn(const Scratch& scratch, const Yarn& yarn, uint32_t k) const {
    const float w = all.position(vertex(yarn, k)).w;
    Vec3 before{0, 0, 0}, after{0, 0, 0};
    float lower = 0, upper = 0;
    if (k > 0) {
      before = scratch.edge[k - 1].xyz();
      lower = w * stiffness(scratch.edge[k - 1].w, yarn, k - 1);
    }
    if (k < yarn.count) {
      after = scratch.edge[k].xyz();
      upper = w * stiffness(scratch.edge[k].w, yarn, k);
    }
    const Vec3 along = direction(before, after);
    const Vec3 push = steps_on(scratch, yarn, k);
    return {-lower, 1 + lower + upper, -upper, w * (push - dot(push, along) * along)};
  }

  /// kg·m: what edge k takes back, as it turns.
  MENISCUS_HD Vec3 taken_back(const Scratch& scratch, const Sideways* ways, const Yarn& yarn,
                              uint32_t k) const {
    return stiffness(scratch.edge[k].w, yarn, k) * (ways[k + 1].right - ways[k].right);
  }
  MENISCUS_HD void move(const Scratch& scratch, const Sideways* ways, const Yarn& yarn, uint32_t k) const {
    Vec3 push = steps_on(scratch, yarn, k);
    if (k > 0) push += -taken_back(scratch, ways, yarn, k - 1);
    if (k < yarn.count) push += taken_back(scratch, ways, yarn, k);
    const uint32_t v = vertex(yarn, k);
    all.push(v, all.at(v), push);
  }
  MENISCUS_HD void note(const Scratch& scratch, const Sideways* ways, const Yarn& yarn, uint32_t k) const {
    const Vec3 push = given(yarn, k).xyz() + step(scratch, yarn, k) - taken_back(scratch, ways, yarn, k);
    multiplier[yarn.first + k] = pbd::with_w(push, scratch.edge[k].w);
  }
};

}  // namespace meniscus::cloth
