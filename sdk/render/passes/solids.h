// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sdk/io/preview/preview.h"
#include "sdk/render/frame/stage.h"
#include "sdk/render/gl/program.h"
#include "sdk/render/meshes/mesh.h"

namespace meniscus::render {

/// Shapes, bodies, cloth and ropes as triangles. Of containers floors cast shadows; all else is up to
/// Vessels.
class Solids {
 public:
  /// May throw what solid_triangles throws.
  explicit Solids(const io::PreviewScene& scene);

  /// What stands still, and bodies where they start.
  const Bounds& bounds() const { return bounds_; }

  /// `states` of the bodies, or none, for where they start.
  /// True where something is not where it was.
  bool place(std::span<const BodyState> states, const io::ClothFrame& cloth, const io::RopeFrame& ropes,
             std::span<const Vec3> cloth_triangle_colors = {});

  void draw_shadows() const;
  void draw() const;
  /// Whether draw() has nothing to do.
  bool empty() const;

 private:
  struct Item {
    Mesh surface;
    Pose pose;
    bool is_vessel;
  };
  void add(const Geometry& geometry, const Pose& pose, Vec3 color);
  void draw(const Program& program, bool with_vessels) const;

  const io::PreviewScene scene_;
  Vec3 up_;
  Bounds bounds_;
  std::vector<Item> items_;  // shapes, then bodies
  Mesh cloth_, ropes_;
  bool moves_ = false;  // something of what was placed last
  Program shadow_{"solids/shadow.vert.glsl", "solids/nothing.frag.glsl"};
  Program solid_{"solids/solid.vert.glsl", "solids/solid.frag.glsl"};
};

}  // namespace meniscus::render
