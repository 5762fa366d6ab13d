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

/// The surfaces of all bodies at one moment, or those of fixed shapes. Corners are counter-clockwise as seen
/// from outside.
struct SurfaceFrame {
  const char* kind = "body";                       ///< what they are: "body" or "shape"
  double time = 0;                                 ///< s
  std::vector<Vec3> vertices;                      ///< m, world
  std::vector<Vec3> velocities;                    ///< m/s, one per vertex
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

  const std::vector<collision::TriangleMesh>& meshes() const { return meshes_; }  ///< in the bodies' frames

 private:
  std::vector<collision::TriangleMesh> meshes_;  // in the bodies' frames
  std::vector<std::string> names_;
};

/// A solid as triangles in its own frame; corners at the same place are one vertex. A plane has none. May
/// throw what solid_triangles throws.
collision::TriangleMesh solid_mesh(const Geometry& geometry);

/// Fixed shapes in place. May throw what solid_triangles throws.
SurfaceFrame shape_surfaces(const std::vector<ShapeDef>& shapes);

}  // namespace meniscus::io
