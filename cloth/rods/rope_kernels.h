// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of RopeSet, and the state that they share.
#pragma once

#include "cloth/rods/elements.h"
#include "cloth/rods/tuning.h"
#include "cloth/solve/push_vertex.h"
#include "pbd/contacts.h"
#include "pbd/math/matrix.h"
#include "pbd/particles.h"

namespace meniscus::cloth::rope_kernels {

using pbd::Vec4;
using pbd::View;

/// The terms of the equation of a segment's Δλ; `right` becomes the solution.
struct Row {
  Sym3 yield;            ///< 1/kg; later the inverse of the pivot
  float mass_a, mass_b;  ///< inverse, 1/kg
  Vec3 right;            ///< m
};

struct RopeView {
  pbd::ParticleView particles;
  View<const RodSegment> segment;
  View<float> start;      ///< m, |x_b − x_a| − l at the substep's start
  View<Vec3> multiplier;  ///< kg·m
  View<float> pull;       ///< kg·m, tension times h², of the last solution
  View<Row> rows;
  float dt;
};

/// Resets the multipliers, and stores the strains that damping is measured from.
struct Begin {
  RopeView ropes;

  MENISCUS_HD void operator()(uint32_t k) const {
    const RodSegment s = ropes.segment[k];
    const uint32_t first = ropes.particles.sorted;
    const View<const Vec4> x = ropes.particles.previous;
    ropes.start[k] = length(x[first + s.b].xyz() - x[first + s.a].xyz()) - s.rest_length;
    ropes.multiplier[k] = {0, 0, 0};
  }
};

/// Writes segment k's row of (J W Jᵀ + A) Δλ = −C − A λ for C = x_b − x_a − l d. λ is the force's impulse
/// times h. The direction d follows the segment, which has no bending stiffness. With n = (x_b − x_a)/|x_b −
/// x_a| and the tension N of the segment
///
///   A = α̃ n nᵀ + l/(h² N) (1 − n nᵀ)
///
/// The second term is the lateral compliance of the segment: Newton's method with the geometric stiffness of
/// a rope under tension. Without it a rope with a weight at its end overshoots (Tournier, Nesme, Gilles &
/// Faure 2015, "Stable Constrained Dynamics"). A rope without tension has no lateral stiffness.
struct Linearize {
  RopeView ropes;

  MENISCUS_HD void operator()(uint32_t k) const {
    const RodSegment s = ropes.segment[k];
    const Vec4 a = at(s.a), b = at(s.b);
    const Vec3 apart = b.xyz() - a.xyz();
    const Vec3 n = normalized_or(apart, {0, 0, 1});
    const float mass =
        a.w + b.w > 0 ? a.w + b.w : 1;  // a segment that is held at both ends also has a solution
    const float damping = s.damping / ropes.dt;
    const float compliance = s.stretch_compliance / (ropes.dt * ropes.dt);
    const Vec3 multiplier = ropes.multiplier[k];
    const float tension = dot(multiplier, n);

    const float strain = length(apart) - s.rest_length;
    const float residual = strain + compliance * tension + damping * (strain - ropes.start[k]);
    const float along = compliance / (1 + damping) + rod_tuning::rope_regularisation * mass;
    const float pull = ropes.pull[k];
    const float lateral = pull * rod_tuning::most_lateral * mass > s.rest_length
                              ? s.rest_length / pull
                              : rod_tuning::most_lateral * mass;
    const Vec3 right = -residual / (1 + damping) * n - lateral * (multiplier - tension * n);
    ropes.rows[k] = {compliance_matrix(n, along, lateral), a.w, b.w, right};
  }

 private:
  MENISCUS_HD Vec4 at(uint32_t vertex) const {
    return ropes.particles.position[ropes.particles.sorted + vertex];
  }
  MENISCUS_HD static Sym3 compliance_matrix(Vec3 n, float along, float lateral) {
    const float d = along - lateral;
    return {lateral + d * n.x * n.x, lateral + d * n.y * n.y, lateral + d * n.z * n.z,
            d * n.x * n.y,           d * n.x * n.z,           d * n.y * n.z};
  }
};

/// Solves a rope in each thread, by elimination and substitution of a block-tridiagonal system (Thomas). The
/// couplings are −w_b and the pivots w_b + E. Elimination then subtracts no nearly equal numbers. So neither
/// the length of a rope nor the weight at its end costs precision:
///
///   E₊ = A₊ + w_b E (E + w_b)⁻¹
///
/// A closed rope is cut. The segment before the cut waits for another iteration.
struct Solve {
  View<const RodChain> chain;
  View<Row> rows;
  int iteration;

  MENISCUS_HD void operator()(uint32_t i) const {
    const RodChain c = chain[i];
    const uint32_t cut = c.closed && iteration % 2 ? c.count / 2 : 0;
    const uint32_t solved = c.count - c.closed;
    Sym3 e{}, pivot{};  // of the row before
    Vec3 right{0, 0, 0};
    for (uint32_t k = 0; k < solved; ++k) {
      Row& row = rows[place(c, cut + k)];
      const float w = row.mass_a;
      right = row.right += w * (pivot * right);
      e = row.yield + (k ? w * commuting_product(e, pivot) : diagonal(w));
      pivot = row.yield = inverse(e + diagonal(row.mass_b));
    }
    Vec3 x{0, 0, 0};  // of the row after
    for (uint32_t k = solved; k-- > 0;) {
      Row& row = rows[place(c, cut + k)];
      x = row.right = row.yield * (row.right + row.mass_b * x);
    }
    if (c.closed) rows[place(c, cut + solved)].right = {0, 0, 0};
  }

 private:
  MENISCUS_HD static uint32_t place(const RodChain& c, uint32_t k) {
    return c.first + (k < c.count ? k : k - c.count);
  }
};

/// x += W Jᵀ Δλ. The thread of a segment moves its first vertex. That of the last segment moves both
/// vertices.
struct Apply {
  RopeView ropes;

  MENISCUS_HD void operator()(uint32_t k) const {
    const RodSegment s = ropes.segment[k];
    const Vec3 push = ropes.rows[k].right;
    const Vec3 multiplier = ropes.multiplier[k] + push;
    ropes.multiplier[k] = multiplier;
    ropes.pull[k] = length(multiplier);
    const Vec3 before = s.before == pbd::no_index ? Vec3{0, 0, 0} : ropes.rows[s.before].right;
    push_vertex(ropes.particles, s.a, before - push);
    if (s.after == pbd::no_index) push_vertex(ropes.particles, s.b, push);
  }
};

}  // namespace meniscus::cloth::rope_kernels
