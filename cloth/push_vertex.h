// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "pbd/particles.h"

namespace meniscus::cloth {

/// a + s b, four at once.
MENISCUS_HD inline pbd::Vec4 plus(const pbd::Vec4& a, float s, const pbd::Vec4& b) {
  return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z, a.w + s * b.w};
}

/// A vertex as a constraint works on it. What has moved it is loaded along with the position, before anything
/// is stored that it might be the same as.
struct Vertex {
  pbd::Vec4 x;      ///< m; w: inverse mass
  pbd::Vec4 moved;  ///< see ParticleView
};

MENISCUS_HD inline Vertex vertex_at(const pbd::ParticleView& particles, uint32_t v) {
  const uint32_t i = particles.sorted + v;
  return {particles.position[i], particles.moved[i]};
}

/// A vertex moved by w times s times an impulse over h, kg·m, of which w is 0. What is held stays, and notes
/// what it withstands.
MENISCUS_HD inline Vertex pushed(const Vertex& vertex, float s, const pbd::Vec4& impulse) {
  const float w = vertex.x.w;
  return {plus(vertex.x, s * w, impulse), plus(vertex.moved, w > 0 ? s * w : s, impulse)};
}

MENISCUS_HD inline void push_vertex(const pbd::ParticleView& particles, uint32_t v, const Vertex& vertex,
                                    float s, const pbd::Vec4& impulse) {
  const uint32_t i = particles.sorted + v;
  const Vertex after = pushed(vertex, s, impulse);
  particles.position[i] = after.x;
  particles.moved[i] = after.moved;
}
MENISCUS_HD inline void push_vertex(const pbd::ParticleView& particles, uint32_t v, Vec3 impulse) {
  push_vertex(particles, v, vertex_at(particles, v), 1, pbd::with_w(impulse, 0));
}

}  // namespace meniscus::cloth
