// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The elements that the preview draws, in world space. A `surface` is an index into Drawing::surfaces.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "pbd/math/vec.h"

namespace meniscus::io {

struct Surface {
  Vec3 albedo;  ///< linear RGB
  float gloss;  ///< 0 is matt, 1 is wet
};

struct Sphere {
  Vec3 center;
  float radius;
  uint32_t surface;
};

/// A triangle, visible from both sides. If its back has another surface, its corners are counter-clockwise as
/// seen from the front.
struct Triangle {
  std::array<Vec3, 3> corners, normals;
  uint32_t surface;
  std::optional<uint32_t> back{};
};

struct Edge {
  Vec3 from, to;
};

/// An endless plane of square tiles in two surfaces, this one and the next.
struct Ground {
  Vec3 origin, normal;
  float tile;  ///< m
  uint32_t surface;
};

struct Drawing {
  std::vector<Surface> surfaces;
  std::vector<Sphere> spheres;
  std::vector<Triangle> triangles;
  std::vector<Edge> edges;
  std::vector<Ground> grounds;

  uint32_t add_surface(const Surface& surface) {
    surfaces.push_back(surface);
    return static_cast<uint32_t>(surfaces.size() - 1);
  }
};

}  // namespace meniscus::io
