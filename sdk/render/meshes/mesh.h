// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Solids, cloth and ropes as triangles with colours.
#pragma once

#include <vector>

#include "sdk/io/cloth_frame.h"
#include "sdk/render/frame/uniforms.h"
#include "sdk/render/gl/objects.h"
#include "sdk/render/meshes/cloth_detail.h"

namespace meniscus::render {

/// The kind of a surface beside its colour. solids/solid.frag.glsl reads it from the colour's last component.
enum class Look { glossy, cloth, rope };

struct Vertex {
  Vec3 position, normal;
  Float4 color;  ///< linear RGB; w: the look
  /// Of ropes: the angle around the line, and the way along it in radii. Of cloth: threads along u and v.
  std::array<float, 2> place{};
};

/// Three vertices per triangle.
using Triangles = std::vector<Vertex>;

/// The surface of a solid in its own frame, in `color` if a mesh has no materials. A container has only its
/// floors. May throw what solid_triangles throws.
Triangles solid_surface(const Geometry& geometry, const Pose& pose, Vec3 up, Vec3 color);
/// Whether a face of a container faces up at this pose; `inwards`: its normal in the container's frame.
bool is_floor(Vec3 inwards, const Pose& pose, Vec3 up);

/// Cloth in the colours of the triangles if there are any, otherwise in those of the pieces. The triangles
/// have no weave then. Each border is rolled.
Triangles cloth_surface(const io::ClothFrame& frame, const std::vector<Vec3>& colors,
                        std::span<const ClothDetail> details, std::span<const BorderEdge> borders,
                        std::span<const Vec3> triangle_colors = {});
Triangles rope_surface(const io::RopeFrame& frame, const std::vector<Vec3>& colors);

/// Triangles in GPU memory.
class Mesh {
 public:
  Mesh();
  void set(const Triangles& triangles);
  void draw() const;
  bool empty() const { return count_ == 0; }

 private:
  DataBuffer vertices_;
  VertexArrayHandle array_;
  GLsizei count_ = 0;
};

}  // namespace meniscus::render
