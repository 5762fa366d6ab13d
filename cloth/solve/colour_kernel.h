// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernel that solves the edges of one colour outside clusters.
#pragma once

#include "cloth/solve/stretch_kernels.h"

namespace meniscus::cloth {

/// The edges of one colour, which share no vertex. Vertices are read and written in global memory.
struct SolveColour {
  stretch_kernels::SolveEdge edge;
  VertexState all;

  template <class D>
  MENISCUS_HD void run(const pbd::SideBySide<D>& together) const {
    edge.run(*this, together, edge.items(together));
  }

  /// The properties of vertices that edges use.
  MENISCUS_HD float inverse_dt() const { return all.inverse_dt; }
  MENISCUS_HD uint32_t piece_number(uint32_t v) const { return all.piece_number(v); }
  template <class D>
  MENISCUS_HD LaneVertex<D> at(const pbd::Places<D>& v) const {
    return {gather(x(), v.index()), gather(accumulated_delta(), v.index())};
  }
  template <class D>
  MENISCUS_HD auto previous(const pbd::Places<D>& v) const {
    return gather(all.particles.previous.from(all.particles.sorted), v.index()).xyz();
  }
  template <class D>
  MENISCUS_HD typename D::Real stretch_damping(const pbd::Places<D>& v) const {
    return all.stretch_damping_by_lane<D>([&](uint32_t lane) { return v.at[lane]; });
  }
  template <class D, class R = typename D::Real>
  MENISCUS_HD void push(const pbd::Places<D>& v, const LaneVertex<D>& vertex, const R& s,
                        const pbd::Vec3Of<R>& positional_impulse) const {
    push_side_by_side(x(), accumulated_delta(), v, vertex, s, positional_impulse);
  }

 private:
  MENISCUS_HD View<Vec4> x() const { return all.particles.position.from(all.particles.sorted); }
  MENISCUS_HD View<Vec4> accumulated_delta() const {
    return all.particles.accumulated_delta.from(all.particles.sorted);
  }
};

}  // namespace meniscus::cloth
