// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The passes that sum up the fluid's thickness for the camera and for the sun.
#pragma once

#include "sdk/render/frame/uniforms.h"
#include "sdk/render/passes/tile_lists.h"

namespace meniscus::render {

/// The amount of fluid along each line of sight and along the sun's light. It is a sum over the particles,
/// each with its part of the volume. Red, green and blue are the absorption. The front layer, from the first
/// surface to the first gap behind it, is summed up apart from the rest.
class FluidThickness {
 public:
  /// The size is that of the camera's picture; the sums have half as many pixels each way.
  FluidThickness(int width, int height);

  /// Pixels along a side of the sun's picture.
  static constexpr int sun_size = 512;
  /// Radius, m, of the disc over which a particle's volume is spread, for the spacing of the particles.
  static constexpr float disc_radius(float spacing) { return 1.6f * spacing; }

  /// Both calls only start the work: see Program::start. The lists are of the full picture. The first
  /// surface, not yet filtered, must be bound for the camera.
  void draw_for_camera(const TileLists& lists, const FrameUniforms& frame,
                       const Texture& scene_distance) const;
  void draw_for_sun(const TileLists& lists, const FrameUniforms& frame) const;

  /// Binds what shaders/fluid/front_and_rest.glsl reads.
  void bind_layers() const;
  const Texture& front() const { return front_; }        ///< a: m
  const Texture& rest() const { return rest_; }          ///< a: m
  const Texture& sun() const { return sun_; }            ///< front layer; a: the least depth, 0 to 1
  const Texture& sun_rest() const { return sun_rest_; }  ///< likewise

 private:
  void draw(const TileLists& lists, const Texture& sums, const Texture& rest, const Matrix4& to_clip,
            float x_per_metre, float y_per_metre, float spacing, bool hides) const;

  Texture front_, rest_, slices_, sun_, sun_rest_;
  Program program_{"fluid/thickness.comp.glsl"};
};

}  // namespace meniscus::render
