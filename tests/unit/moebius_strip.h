// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A surface with one side.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "pbd/math/vec.h"

namespace meniscus::tests {

/// A strip of 12 quadrilaterals that ends as its own back, as a mesh of vertices and triangles.
template <class Mesh>
Mesh moebius_strip() {
  Mesh mesh;
  constexpr uint32_t count = 12;
  for (uint32_t i = 0; i < count; ++i) {
    const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / count;
    const Vec3 out{std::cos(a), 0, std::sin(a)};
    const Vec3 across = 0.3f * (std::cos(a / 2) * out + std::sin(a / 2) * Vec3{0, 1, 0});
    mesh.vertices.push_back(out - across);
    mesh.vertices.push_back(out + across);
  }
  for (uint32_t i = 0; i < count; ++i) {
    const bool last = i + 1 == count;
    const uint32_t a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {a, d, c}});
  }
  return mesh;
}

}  // namespace meniscus::tests
