// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The pass that draws particles as balls in the colours of a value.
#pragma once

#include <meniscus/outputs.h>

#include "sdk/render/frame/views.h"
#include "sdk/render/gl/program.h"

namespace meniscus::render {

/// Particles as balls in the colours of a value.
class Balls {
 public:
  /// `fluid_colors` are the colours that ParticleView::phase shows; empty: that of water.
  explicit Balls(const std::vector<Vec3>& fluid_colors);

  /// Sets balls at the ellipsoids, by the values of the view. There are none if the view shows the fluid's
  /// surface.
  void set(std::span<const Ellipsoid> ellipsoids, const ViewData& view);
  bool empty() const { return count_ == 0; }
  void draw(float radius) const;

 private:
  struct Ball {
    Vec3 centre;
    float place;  ///< in the colour map, 0 to 1
  };
  DataBuffer balls_;
  VertexArrayHandle array_;
  Texture sequence_, balance_, fluids_;
  const Texture* colors_ = &sequence_;
  GLsizei count_ = 0;
  Program program_{"views/ball.vert.glsl", "views/ball.frag.glsl"};
};

/// The colours of a map, from left to right.
Texture color_texture(ColorMap map);

}  // namespace meniscus::render
