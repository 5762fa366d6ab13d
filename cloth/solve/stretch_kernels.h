// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of stretch and shear, of edges and of triangles, with their warm start.
#pragma once

#include "cloth/build/constraints.h"
#include "cloth/solve/edge_compliance.h"
#include "cloth/solve/load_kernels.h"
#include "cloth/solve/tuning.h"
#include "cloth/solve/vertex_state.h"
#include "pbd/device/side_by_side.h"

namespace meniscus::cloth::stretch_kernels {

using pbd::gather;
using pbd::gather_words;
using pbd::max;
using pbd::scatter;
using pbd::square_root;

struct SolveEdge {
  View<const EdgeConstraint> edges;  ///< with vertices as numbered in their cluster
  /// kg·m: λ n, and λ. Until the end of the substep, the step of the last round stands in place of the first
  /// component.
  View<Vec4> multiplier;
  float relaxation;  ///< ω of successive over-relaxation
  float fraction;    ///< of the present multiplier
  float momentum;    ///< fraction of the last round's step that is repeated, where an edge pulls
  /// Chains hold the lengths around the edge, and the edge has a warm start. What remains for it is shear,
  /// which it resists under compression as under tension. Rows that slide along themselves compress all
  /// diagonals. Pieces loaded by fluid are excluded, if `loaded` tells which these are: they bulge, and must
  /// buckle. So are fresh pieces, which have no warm start.
  bool shears;
  View<const uint32_t> loaded;  ///< by piece, see load_kernels::Load
  bool ends;                    ///< the last sweep of the substep: what remains is for the next one
  float next_fraction;  ///< of the multiplier for the next substep, where the edge pulls (λ < 0) or shears;
                        ///< other pushes keep less, as they buckle

  MENISCUS_HD void prefetch(uint32_t k) const {
    pbd::prefetch(edges, k);
    pbd::prefetch(multiplier, k);
  }

  /// Edges that are solved side by side, with their last multipliers and steps.
  template <class D>
  struct Items {
    pbd::Places<D> from, to;
    pbd::Vec4Of<typename D::Real> constants;
    typename D::Real multiplier, last_step;

    MENISCUS_HD void set(uint32_t lane, const EdgeConstraint& e) {
      from.at[lane] = e.a;
      to.at[lane] = e.b;
    }
  };
  template <class D>
  MENISCUS_HD Items<D> items(const pbd::SideBySide<D>& together) const {
    Items<D> all;
    for (uint32_t lane = 0; lane < D::lane_count; ++lane) all.set(lane, edges[together.items.at[lane]]);
    all.constants = gather_words(edges, together.index());
    const pbd::Vec4Of<typename D::Real> last = gather(multiplier, together.index());
    all.multiplier = last.w;
    all.last_step = last.x;
    return all;
  }

  template <class D, class Vertices>
  MENISCUS_HD void run(const Vertices& vertices, const pbd::SideBySide<D>& together,
                       const Items<D>& items) const {
    using Real = typename D::Real;
    using Vector = pbd::Vec3Of<Real>;
    const pbd::Places<D>&from = items.from, &to = items.to;
    const Real zero(0), rest = items.constants.z, before = Real(fraction) * items.multiplier;
    const LaneVertex<D> a = vertices.at(from), b = vertices.at(to);
    const Real weight = a.x.w + b.x.w;
    const Vector d = b.x.xyz() - a.x.xyz();
    const auto was = [&] { return vertices.previous(to) - vertices.previous(from); };
    const Real l = square_root(dot(d, d)), c = l - rest;
    const Real shearing = shearing_by_lane<D>(vertices, from);
    const Real opens =
        select_less(zero, shearing, Real(cloth_tuning::shear_recovery_rate / vertices.inverse_dt()),
                    Real(cloth_tuning::recovery_rate / vertices.inverse_dt()));
    const Real compliance =
        edge_compliance(items.constants.w, rest, c, weight, vertices.inverse_dt(), opens, [&] {
          const Vector then = was();
          return square_root(dot(then, then));
        });
    const Real damping = vertices.template stretch_damping<D>(from), nearly_none(1e-12f);
    const Real inverse_l = select_less(l, nearly_none, zero, Real(1) / l);
    Real rate = zero;
    if (less_mask(zero, damping) != 0) rate = inverse_l * dot(d, d - was());
    const Real whole = xpbd_step(c, rate, weight, before, compliance, damping);
    const Real pulling = Real(relaxation) * whole + Real(momentum) * items.last_step;
    const Real wanted = select_less(c, zero, of_pressed(whole, before, shearing), pulling);
    // An edge without a direction, or one that cannot yield at all, is left unchanged.
    const Real yielding = together.if_any(weight + compliance);
    const Real step = select_less(zero, yielding, wanted, zero), push = inverse_l * step, now = before + step;
    const auto note = [&](const Vector& to_go_on_with, const Real& lambda) {
      scatter(multiplier, together.index(), {to_go_on_with.x, to_go_on_with.y, to_go_on_with.z, lambda},
              less_mask(zero, yielding));
    };
    if (ends) {
      const Real left = select_less(l, nearly_none, zero, kept(now, weight, rest, shearing));
      note((inverse_l * left) * d, left);
    } else {
      note({select_less(c, zero, zero, step), zero, zero}, select_less(l, nearly_none, zero, now));
    }
    vertices.push(from, a, -push, d);
    vertices.push(to, b, push, d);
  }

 private:
  /// The applied part of a step that lengthens a compressed edge. What only reduces a pull is applied in
  /// full, and the rest by a fraction.
  template <class Real>
  MENISCUS_HD Real of_pressed(const Real& step, const Real& before, const Real& shearing) const {
    const Real least(cloth_tuning::compressed_relaxation), pull = max(Real(0), -before);
    const Real sheared = select_less(pull, step, pull + least * (step - pull), step);
    return select_less(Real(0), shearing, sheared, least * step);
  }

  /// 1 in lanes whose edges shear, else 0.
  template <class D, class Vertices>
  MENISCUS_HD typename D::Real shearing_by_lane(const Vertices& vertices, const pbd::Places<D>& v) const {
    using Real = typename D::Real;
    if (!shears || loaded.count == 0) return Real(shears ? 1.0f : 0.0f);
    return pbd::by_lane<D>([&](uint32_t lane) {
      return loaded[vertices.piece_number(v.at[lane])] >= load_kernels::fluid ? 0.0f : 1.0f;
    });
  }

  /// The multiplier that is kept for the next substep. It moves the ends by the rest length at most, since a
  /// load on an edge may be thousands of times heavier than its ends.
  template <class Real>
  MENISCUS_HD Real kept(const Real& lambda, const Real& weight, const Real& rest,
                        const Real& shearing) const {
    const Real of_push = select_less(Real(0), shearing, Real(next_fraction),
                                     Real(cloth_tuning::pushing_start * next_fraction));
    const Real most = rest / weight, part = select_less(lambda, Real(0), Real(next_fraction), of_push);
    return max(-most, -max(-most, -part * lambda));
  }
};

/// Sums up the pushes that edges start with, by vertex.
struct StartPushes {
  View<const uint32_t> edge_end_start, edge_ends;
  View<const Vec4> multiplier;
  float fraction;
  View<Vec4> pending;  ///< kg·m, by vertex; w is 0

  MENISCUS_HD void operator()(uint32_t v) const {
    Vec4 push{0, 0, 0, 0};
    for (uint32_t k = edge_end_start[v]; k < edge_end_start[v + 1]; ++k)
      push = plus(push, edge_ends[k] % 2 ? fraction : -fraction, load(multiplier, edge_ends[k] / 2));
    push.w = 0;
    pending[v] = push;
  }
};

/// Moves vertices by their pending pushes.
struct GivePending {
  View<const Vec4> pending;
  VertexState vertices;

  MENISCUS_HD void operator()(uint32_t v) const { vertices.push(v, vertices.at(v), 1, pending[v]); }
};

/// The strains of a triangle along the warp, along the weft and in shear, one after the other.
struct SolveStrain {
  View<const StrainConstraint> strains;
  View<Vec4> multiplier;  ///< kg·m², of warp, weft and shear
  float relaxation;
  bool starts;  ///< the multipliers of the substep start here

  struct Corners {
    Vec4 x[3];
    Vec3 positional_impulse[3];
  };
  /// One strain and its gradients at b and c. The gradient at a is minus their sum.
  struct Strain {
    float value;
    Vec3 by_b, by_c;
  };

  MENISCUS_HD void prefetch(uint32_t k) const {
    pbd::prefetch(strains, k);
    pbd::prefetch(multiplier, k);
  }

  template <class Vertices>
  MENISCUS_HD void operator()(const Vertices& vertices, uint32_t k) const {
    const StrainConstraint s = strains[k];
    const Vec4 start = starts ? Vec4{0, 0, 0, 0} : multiplier[k];
    const Vertex a = vertices.at(s.a), b = vertices.at(s.b), c = vertices.at(s.c);
    Corners t{{a.x, b.x, c.x}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
    const float scale = vertices.inverse_dt() * vertices.inverse_dt();
    Vec4 now = start;
    now.x = solve(vertices, s, t, stretch(s, t, 0), start.x, scale * s.warp_compliance, true);
    now.y = solve(vertices, s, t, stretch(s, t, 1), start.y, scale * s.weft_compliance, true);
    now.z = solve(vertices, s, t, shear(s, t), start.z, scale * s.shear_compliance, false);
    multiplier[k] = now;
    vertices.push(s.a, a, t.positional_impulse[0]);
    vertices.push(s.b, b, t.positional_impulse[1]);
    vertices.push(s.c, c, t.positional_impulse[2]);
  }

  MENISCUS_HD static Vec3 direction(const StrainConstraint& s, const Corners& t, int axis) {
    const Vec3 ab = t.x[1].xyz() - t.x[0].xyz(), ac = t.x[2].xyz() - t.x[0].xyz();
    return s.inverse_rest[axis] * ab + s.inverse_rest[2 + axis] * ac;
  }

  MENISCUS_HD static Strain stretch(const StrainConstraint& s, const Corners& t, int axis) {
    const Vec3 f = direction(s, t, axis);
    const float l = length(f);
    const Vec3 n = l > 1e-12f ? f / l : Vec3{0, 0, 0};
    return {l - 1, s.inverse_rest[axis] * n, s.inverse_rest[2 + axis] * n};
  }

  MENISCUS_HD static Strain shear(const StrainConstraint& s, const Corners& t) {
    const Vec3 fu = direction(s, t, 0), fv = direction(s, t, 1);
    const float lu = length(fu), lv = length(fv);
    if (lu < 1e-12f || lv < 1e-12f) return {0, {0, 0, 0}, {0, 0, 0}};
    const Vec3 u = fu / lu, v = fv / lv;
    const float cosine = dot(u, v);
    const Vec3 by_u = (v - cosine * u) / lu, by_v = (u - cosine * v) / lv;
    return {cosine, s.inverse_rest[0] * by_u + s.inverse_rest[1] * by_v,
            s.inverse_rest[2] * by_u + s.inverse_rest[3] * by_v};
  }

  /// Moves the corners, and returns the new multiplier.
  template <class Vertices>
  MENISCUS_HD float solve(const Vertices& vertices, const StrainConstraint& s, Corners& t,
                          const Strain& strain, float before, float compliance, bool stretches) const {
    const Vec3 gradient[3] = {-(strain.by_b + strain.by_c), strain.by_b, strain.by_c};
    const uint32_t number[3] = {s.a, s.b, s.c};
    const float damping = vertices.stretch_damping(s.a);
    float weight = 0, rate = 0;
    for (int i = 0; i < 3; ++i) {
      weight += t.x[i].w * dot(gradient[i], gradient[i]);
      if (damping > 0) rate += dot(gradient[i], t.x[i].xyz() - vertices.previous(number[i]).xyz());
    }
    // A strain with unlimited compliance, or without a gradient, is left unchanged.
    if (!(weight + compliance > 0) || !(compliance < 1e30f)) return before;
    const float relaxing = strain.value < 0 && stretches ? cloth_tuning::compressed_relaxation : relaxation;
    const float step = relaxing * xpbd_step(strain.value, rate, weight, before, compliance, damping);
    for (int i = 0; i < 3; ++i) {
      t.positional_impulse[i] += step * gradient[i];
      t.x[i] = pbd::with_w(t.x[i].xyz() + t.x[i].w * step * gradient[i], t.x[i].w);
    }
    return before + step;
  }
};

}  // namespace meniscus::cloth::stretch_kernels
