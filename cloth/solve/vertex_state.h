// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What all kernels of cloth use: the state of vertices, and the XPBD step of one constraint.
#pragma once

#include "cloth/build/piece.h"
#include "cloth/solve/push_vertex.h"
#include "pbd/device/scalar.h"
#include "pbd/particles.h"

namespace meniscus::cloth {

using pbd::Vec4;
using pbd::View;

/// The vertices of all cloth, by number.
struct VertexState {
  pbd::ParticleView particles;
  View<const Piece> pieces;
  CommonDamping damping;
  float inverse_dt = 0;  ///< 1/s

  MENISCUS_HD Vec4 position(uint32_t v) const { return particles.position[particles.sorted + v]; }
  MENISCUS_HD Vertex at(uint32_t v) const { return vertex_at(particles, v); }
  MENISCUS_HD Vec4 previous(uint32_t v) const { return particles.previous[particles.sorted + v]; }
  /// m, from the start of the substep to the present position x of v.
  MENISCUS_HD Vec3 displacement(uint32_t v, const Vec4& x) const { return x.xyz() - previous(v).xyz(); }
  MENISCUS_HD uint32_t piece_number(uint32_t v) const {
    return pbd::phase_group(particles.phase[particles.sorted + v]);
  }
  MENISCUS_HD const Piece& piece_of(uint32_t v) const { return pieces[piece_number(v)]; }
  /// τ/h, with Rayleigh's β = τ/α.
  MENISCUS_HD float stretch_damping(uint32_t v) const {
    return inverse_dt * (damping.stretch >= 0 ? damping.stretch : piece_of(v).stretch_damping);
  }
  MENISCUS_HD float bending_damping(uint32_t v) const {
    return inverse_dt * (damping.bending >= 0 ? damping.bending : piece_of(v).bending_damping);
  }
  /// The same for vertex v(lane) in each lane.
  template <class D, class Number>
  MENISCUS_HD typename D::Real stretch_damping_by_lane(const Number& v) const {
    if (damping.stretch >= 0) return typename D::Real(inverse_dt * damping.stretch);
    return pbd::by_lane<D>([&](uint32_t lane) { return stretch_damping(v(lane)); });
  }

  /// Pushes v by s times a positional impulse (kg·m; w is 0).
  MENISCUS_HD void push(uint32_t v, const Vertex& vertex, float s, const Vec4& positional_impulse) const {
    push_vertex(particles, v, vertex, s, positional_impulse);
  }
  MENISCUS_HD void push(uint32_t v, const Vertex& vertex, Vec3 positional_impulse) const {
    push(v, vertex, 1, pbd::with_w(positional_impulse, 0));
  }
};

/// The increment of a constraint's multiplier (Macklin, Müller & Chentanez 2016, eq. 26):
///
///   Δλ = (−C − α̃ λ − γ ∇C·(x − x₀)) / ((1 + γ) Σ w|∇C|² + α̃)
///
/// It holds for any number of constraints with a common weight Σ w|∇C|². V is R or a vector of R, and R may
/// have lanes. `damping` is τ/h, and γ is `damping` times α̃/(α̃ + weight). A constraint that is stiffer than
/// a substep resolves acts with the stiffness that the solve gives it, and is damped in proportion to that.
/// Otherwise damping would keep unyielding cloth from its length.
template <class V, class R>
MENISCUS_HD V xpbd_step(const V& c, const V& rate, const R& weight, const V& multiplier, const R& compliance,
                        const R& damping) {
  const R gamma = select_less(R(0), damping, damping * compliance / (compliance + weight), R(0));
  return R(-1) / ((R(1) + gamma) * weight + compliance) * (c + compliance * multiplier + gamma * rate);
}

}  // namespace meniscus::cloth
