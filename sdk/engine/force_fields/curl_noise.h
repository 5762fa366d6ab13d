// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A vector field without divergence: the curl of gradient noise.
#pragma once

#include "pbd/math/random.h"
#include "pbd/math/vec.h"

namespace meniscus::force_kernels {

/// With this factor the mean square of the curl over space and patterns is 1. It follows from the weights
/// below and gradients that are even in a cube: ⟨|∇×ψ|²⟩ = 6 · ⅓ · ∫ Σ |∂w d + w e|² over a cell.
inline constexpr float curl_scale = 0.819619769f;

/// The weight of a corner along one axis (Perlin 2002), and its slope.
struct CornerWeight {
  float value, slope;

  MENISCUS_HD static CornerWeight of(float f, uint32_t corner) {
    const float rising = f * f * f * (f * (6 * f - 15) + 10), slope = 30 * f * f * (f - 1) * (f - 1);
    return corner ? CornerWeight{rising, slope} : CornerWeight{1 - rising, -slope};
  }
};

/// The gradient of potential k at a node: each component is even in [−1, 1].
MENISCUS_HD inline Vec3 node_gradient(uint32_t x, uint32_t y, uint32_t z, uint32_t key) {
  const Vec3 r = pbd::random_numbers(x ^ key * 0x9e3779b9u, y + key, z);
  return 2.0f * r - Vec3{1, 1, 1};
}

/// The node below a coordinate. Far out, where floats are coarser than nodes, one node stands for all.
MENISCUS_HD inline float node_below(float q) {
  constexpr float furthest = 1e9f;
  const float below = floorf(q);
  return below > furthest ? furthest : below < -furthest ? -furthest : below;
}

/// ∇ × ψ at q, in distances between nodes, where the three components of ψ are gradient noise (Perlin 2002).
/// Taking the curl makes it free of divergence (Bridson, Houriham & Nordenstam 2007).
MENISCUS_HD inline Vec3 curl_noise(Vec3 q, uint32_t seed) {
  const Vec3 node{node_below(q.x), node_below(q.y), node_below(q.z)};
  const Vec3 f = q - node;
  const auto x = static_cast<uint32_t>(static_cast<int32_t>(node.x));
  const auto y = static_cast<uint32_t>(static_cast<int32_t>(node.y));
  const auto z = static_cast<uint32_t>(static_cast<int32_t>(node.z));
  Vec3 slope[3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  for (uint32_t corner = 0; corner < 8; ++corner) {
    const uint32_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
    const CornerWeight a = CornerWeight::of(f.x, i), b = CornerWeight::of(f.y, j),
                       c = CornerWeight::of(f.z, k);
    const Vec3 away = f - Vec3{static_cast<float>(i), static_cast<float>(j), static_cast<float>(k)};
    const Vec3 change{a.slope * b.value * c.value, a.value * b.slope * c.value, a.value * b.value * c.slope};
    const float weight = a.value * b.value * c.value;
    for (uint32_t potential = 0; potential < 3; ++potential) {
      const Vec3 g = node_gradient(x + i, y + j, z + k, 3 * seed + potential);
      slope[potential] += dot(g, away) * change + weight * g;
    }
  }
  return curl_scale * Vec3{slope[2].y - slope[1].z, slope[0].z - slope[2].x, slope[1].x - slope[0].y};
}

}  // namespace meniscus::force_kernels
