// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The passes that draw shapes, bodies, cloth and ropes.
#pragma once

#include <span>

#include "sdk/io/preview/preview.h"
#include "sdk/render/frame/stage.h"
#include "sdk/render/gl/program.h"
#include "sdk/render/meshes/mesh.h"

namespace meniscus::render {

/// Shapes, bodies, cloth and ropes as triangles. Of containers only the floors cast shadows; Vessels draws
/// the rest.
class Solids {
 public:
  /// May throw what solid_triangles throws.
  explicit Solids(const io::PreviewScene& scene);

  /// Bounds of the static objects, and of bodies at their start.
  const Bounds& bounds() const { return bounds_; }

  /// `states` of the bodies; empty: at their start. Returns true if something has moved.
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
  void measure(const io::ClothFrame& cloth);

  const io::PreviewScene scene_;
  Vec3 up_;
  Bounds bounds_;
  std::vector<Item> items_;  // shapes, then bodies
  Mesh cloth_, ropes_;
  std::vector<ClothDetail> details_;                // of the first frame with cloth: threads stay as many
  std::vector<std::array<uint32_t, 3>> triangles_;  // of the cloth that has these borders
  std::vector<BorderEdge> borders_;
  bool moves_ = false;  // something moved at the last placement
  Program shadow_{"solids/shadow.vert.glsl", "solids/nothing.frag.glsl"};
  Program solid_{"solids/solid.vert.glsl", "solids/solid.frag.glsl"};
};

}  // namespace meniscus::render
