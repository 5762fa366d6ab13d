// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernel of dihedral hinges. Isometric bending is solved in bending_solver.h.
#pragma once

#include "cloth/build/constraints.h"
#include "cloth/solve/vertex_state.h"

namespace meniscus::cloth::bending_kernels {

/// The angle θ of a hinge, and its gradient.
struct Fold {
  float angle;
  Vec3 gradient[4];  ///< 1/m, at a, b, c and d
  bool defined;
};

/// Gradients as in Bridson, Marino & Fedkiw 2003: c and d move along the normals of their triangles, and a
/// and b balance force and torque.
MENISCUS_HD inline Fold fold_of(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 e = b - a, n1 = cross(e, c - a), n2 = cross(d - a, e);
  const float e2 = dot(e, e), n1n1 = dot(n1, n1), n2n2 = dot(n2, n2);
  Fold f{};
  f.defined = n1n1 > 1e-12f * e2 * e2 && n2n2 > 1e-12f * e2 * e2;
  if (!f.defined) return f;
  const float l = sqrtf(e2);
  f.angle = atan2f(dot(cross(n2, n1), e) / l, dot(n1, n2));
  const Vec3 by_c = (l / n1n1) * n1, by_d = (l / n2n2) * n2;
  const float at_c = dot(c - a, e) / e2, at_d = dot(d - a, e) / e2;
  f.gradient[0] = -((1 - at_c) * by_c + (1 - at_d) * by_d);
  f.gradient[1] = -(at_c * by_c + at_d * by_d);
  f.gradient[2] = by_c;
  f.gradient[3] = by_d;
  return f;
}

/// A dihedral hinge.
struct SolveHinge {
  View<const HingeConstraint> hinges;
  View<float> multiplier;  ///< kg·m²; empty if no later iteration continues from it
  bool starts;

  MENISCUS_HD void prefetch(uint32_t k) const {
    pbd::prefetch(hinges, k);
    if (!starts) pbd::prefetch(multiplier, k);
  }

  template <class Vertices>
  MENISCUS_HD void operator()(const Vertices& vertices, uint32_t k) const {
    const HingeConstraint h = hinges[k];
    const uint32_t number[4] = {h.a, h.b, h.c, h.d};
    const Vertex x[4] = {vertices.at(h.a), vertices.at(h.b), vertices.at(h.c), vertices.at(h.d)};
    const Fold fold = fold_of(x[0].x.xyz(), x[1].x.xyz(), x[2].x.xyz(), x[3].x.xyz());
    const float before = starts ? 0 : multiplier[k];
    if (starts && multiplier.count != 0) multiplier[k] = 0;
    if (!fold.defined) return;
    const float damping = vertices.bending_damping(h.a);
    float weight = 0, rate = 0;
    MENISCUS_UNROLL
    for (int i = 0; i < 4; ++i) {
      weight += x[i].x.w * dot(fold.gradient[i], fold.gradient[i]);
      if (damping > 0) rate += dot(fold.gradient[i], x[i].x.xyz() - vertices.previous(number[i]).xyz());
    }
    if (weight == 0) return;
    const float compliance = h.compliance * vertices.inverse_dt() * vertices.inverse_dt();
    const float step =
        xpbd_step(turned_from(h.rest_angle, fold.angle), rate, weight, before, compliance, damping);
    if (multiplier.count != 0) multiplier[k] = before + step;
    MENISCUS_UNROLL
    for (int i = 0; i < 4; ++i) vertices.push(number[i], x[i], step * fold.gradient[i]);
  }

  /// θ − θ₀, taken the shorter way round.
  MENISCUS_HD static float turned_from(float rest, float angle) {
    constexpr float pi = 3.14159265f;
    const float turn = angle - rest;
    return turn > pi ? turn - 2 * pi : turn < -pi ? turn + 2 * pi : turn;
  }
};

}  // namespace meniscus::cloth::bending_kernels
