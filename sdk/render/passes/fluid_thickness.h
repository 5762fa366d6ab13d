// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/render/passes/particles.h"
#include "sdk/render/uniforms.h"

namespace meniscus::render {

/// How much fluid lies along each line of sight, and of the sun's light: sums over the particles, each of
/// which has its share of the volume. Red, green and blue are what it absorbs.
class FluidThickness {
 public:
  /// Of the camera's picture; the sums have half as many pixels each way.
  FluidThickness(int width, int height);

  /// `spacing` of the particles, m.
  void draw_for_camera(const Particles& particles, const FrameUniforms& frame, const Texture& solid_depth,
                       float spacing);
  void draw_for_sun(const Particles& particles, const FrameUniforms& frame, float spacing);

  const Texture& camera() const { return camera_; }  ///< a: m
  const Texture& sun() const { return sun_; }        ///< a: the least depth, 0 to 1

 private:
  void draw(const Particles& particles, const Matrix4& to_clip, float x_per_metre, float y_per_metre,
            float spacing, bool hides) const;

  Texture camera_, sun_;
  Target to_camera_, to_sun_;
  Program program_{"thickness.vert.glsl", "thickness.frag.glsl"};
};

}  // namespace meniscus::render
