// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Surfaces of bodies at one moment, as the writers take them.
#pragma once

#include <meniscus/bodies.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "collision/mesh/mesh.h"

namespace meniscus::io {

/// The surfaces of all bodies at one moment. Corners are counter-clockwise as seen from outside.
struct SurfaceFrame {
  double time = 0;                                 ///< s
  std::vector<Vec3> vertices;                      ///< m, world
  std::vector<std::array<uint32_t, 3>> triangles;  ///< those of the first body first, then the next
  std::vector<uint32_t> bodies;                    ///< one per triangle: its body, in the order of the scene
  std::vector<std::string> names;                  ///< of the bodies
};

/// Bodies as triangles: the triangles are made once, and then only moved.
class BodySurfaces {
 public:
  /// May throw what solid_triangles throws.
  explicit BodySurfaces(const std::vector<BodyDef>& bodies);

  /// `states` in the order of the bodies. Throws Error(invalid_argument) unless there is one per body.
  SurfaceFrame at(double time, std::span<const BodyState> states) const;

 private:
  std::vector<collision::TriangleMesh> meshes_;  // in the bodies' frames
  std::vector<std::string> names_;
};

}  // namespace meniscus::io
