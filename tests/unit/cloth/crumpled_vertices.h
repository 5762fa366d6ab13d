// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Vertices of a crumpled mesh, for tests of constraint kernels.
#pragma once

#include <random>
#include <utility>
#include <vector>

#include "cloth/build/cloth_mesh.h"
#include "cloth/solve/vertex_state.h"

namespace meniscus::cloth {

template <class T>
pbd::View<T> view_of(std::vector<T>& values) {
  return {values.data(), static_cast<uint32_t>(values.size())};
}
template <class T>
pbd::View<const T> view_of(const std::vector<T>& values) {
  return {values.data(), static_cast<uint32_t>(values.size())};
}

/// A crumpled mesh's vertices, of two pieces with damping of their own, some of them held.
struct CrumpledVertices {
  std::vector<pbd::Vec4> position, previous, moved;
  std::vector<pbd::Phase> phase;
  std::vector<Piece> pieces{{.stretch_damping = 0.002f, .bending_damping = 0.01f}, {.stretch_damping = 0}};

  explicit CrumpledVertices(const ClothMesh& mesh) {
    std::mt19937 bits(11);
    std::uniform_real_distribution<float> any(-1, 1);
    const auto near = [&](Vec3 x) { return x + 0.01f * Vec3{any(bits), any(bits), any(bits)}; };
    for (const Vec3& x : mesh.vertices) {
      previous.push_back(pbd::with_w(near(x), 0));
      position.push_back(pbd::with_w(near(x), bits() % 9 ? 300 + 200 * any(bits) : 0));
      phase.push_back(bits() % 2);
    }
    moved.resize(position.size(), {0, 0, 0, 0});
  }

  VertexState state() {
    VertexState all;
    all.particles.position = view_of(position);
    all.particles.previous = view_of(std::as_const(previous));
    all.particles.accumulated_delta = view_of(moved);
    all.particles.phase = view_of(std::as_const(phase));
    all.pieces = view_of(std::as_const(pieces));
    all.inverse_dt = 300;
    return all;
  }
};

/// All numbers, one after the other.
inline std::vector<float> numbers_of(std::initializer_list<const std::vector<pbd::Vec4>*> vectors) {
  std::vector<float> all;
  for (const auto* values : vectors) {
    for (const pbd::Vec4& v : *values) all.insert(all.end(), {v.x, v.y, v.z, v.w});
  }
  return all;
}

}  // namespace meniscus::cloth
