// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Moves a vertex by a positional impulse, alone or one vertex in each SIMD lane. A positional impulse is an
// impulse times the substep, kg·m (Müller et al. 2020).
#pragma once

#include "pbd/device/scalar.h"
#include "pbd/particles.h"

namespace meniscus::cloth {

using pbd::less_mask;
using pbd::select_less;

/// a + s b, for four components at once.
MENISCUS_HD inline pbd::Vec4 plus(const pbd::Vec4& a, float s, const pbd::Vec4& b) {
  return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z, a.w + s * b.w};
}

/// A vertex while a constraint works on it. The accumulated delta is loaded together with the position,
/// before any store that might alias it.
struct Vertex {
  pbd::Vec4 x;                  ///< m; w: inverse mass
  pbd::Vec4 accumulated_delta;  ///< see ParticleView
};

MENISCUS_HD inline Vertex vertex_at(const pbd::ParticleView& particles, uint32_t v) {
  const uint32_t i = particles.sorted + v;
  return {particles.position[i], particles.accumulated_delta[i]};
}

/// A vertex moved by w times s times a positional impulse, whose w is 0. A held vertex stays, and records the
/// positional impulse as its reaction.
MENISCUS_HD inline Vertex pushed(const Vertex& vertex, float s, const pbd::Vec4& positional_impulse) {
  const float w = vertex.x.w;
  return {plus(vertex.x, s * w, positional_impulse),
          plus(vertex.accumulated_delta, w > 0 ? s * w : s, positional_impulse)};
}

MENISCUS_HD inline void push_vertex(const pbd::ParticleView& particles, uint32_t v, const Vertex& vertex,
                                    float s, const pbd::Vec4& positional_impulse) {
  const uint32_t i = particles.sorted + v;
  const Vertex after = pushed(vertex, s, positional_impulse);
  particles.position[i] = after.x;
  particles.accumulated_delta[i] = after.accumulated_delta;
}
MENISCUS_HD inline void push_vertex(const pbd::ParticleView& particles, uint32_t v, Vec3 positional_impulse) {
  push_vertex(particles, v, vertex_at(particles, v), 1, pbd::with_w(positional_impulse, 0));
}

/// A vertex in each of D's lanes.
template <class D>
struct LaneVertex {
  pbd::Vec4Of<typename D::Real> x, accumulated_delta;
};

/// pushed() for one vertex in each lane: pushes by s times a positional impulse. Lanes may share a vertex if
/// all but one of them push it by 0.
template <class D, class R = typename D::Real>
MENISCUS_HD void push_side_by_side(pbd::View<pbd::Vec4> x, pbd::View<pbd::Vec4> accumulated_delta,
                                   const pbd::Places<D>& v, const LaneVertex<D>& vertex, const R& s,
                                   const pbd::Vec3Of<R>& positional_impulse) {
  const R zero(0), w = vertex.x.w, fraction = s * w, taken = select_less(zero, w, fraction, s);
  const auto times = [&](const R& by) {
    return pbd::Vec4Of<R>{by * positional_impulse.x, by * positional_impulse.y, by * positional_impulse.z,
                          zero};
  };
  if constexpr (D::lane_count == 1) {
    const auto sum = [](const pbd::Vec4Of<float>& a, const pbd::Vec4Of<float>& b) {
      return pbd::Vec4{a.x + b.x, a.y + b.y, a.z + b.z, a.w};
    };
    x[v.at[0]] = sum(vertex.x, times(fraction));
    accumulated_delta[v.at[0]] = sum(vertex.accumulated_delta, times(taken));
  } else {
    // The step, transposed to one row a lane, is added in memory. So `vertex` need not be transposed back.
    const auto step = rows(times(fraction));
    add(x, v.index(), step);
    const bool all_move = less_mask(zero, w) == (1u << D::lane_count) - 1;
    add(accumulated_delta, v.index(), all_move ? step : rows(times(taken)));
  }
}

}  // namespace meniscus::cloth
