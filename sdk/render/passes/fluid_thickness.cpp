// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Dispatches the shaders that sum up the fluid's thickness.
#include "sdk/render/passes/fluid_thickness.h"

namespace meniscus::render {

FluidThickness::FluidThickness(int width, int height)
    : front_(GL_RGBA32F, (width + 1) / 2, (height + 1) / 2),
      rest_(GL_RGBA32F, (width + 1) / 2, (height + 1) / 2),
      slices_(GL_RGBA32UI, (width + 1) / 2, (height + 1) / 2),
      sun_(GL_RGBA32F, sun_size, sun_size),
      sun_rest_(GL_RGBA32F, sun_size, sun_size) {}

void FluidThickness::draw(const TileLists& lists, const Texture& sums, const Texture& rest,
                          const Matrix4& to_clip, float x_per_metre, float y_per_metre, float spacing,
                          bool hides) const {
  program_.use();
  glUniformMatrix4fv(1, 1, GL_FALSE, to_clip.data());
  glUniform2f(2, x_per_metre, y_per_metre);
  glUniform1f(3, disc_radius(spacing));
  glUniform1i(4, hides);
  sums.bind_image(0);
  rest.bind_image(1);
  lists.start(program_, 2);  // see shaders/fluid/thickness.comp.glsl
}

void FluidThickness::draw_for_camera(const TileLists& lists, const FrameUniforms& frame,
                                     const Texture& scene_distance) const {
  scene_distance.bind(unit::depth);
  const Matrix4 to_clip = frame.projection * frame.view;
  slices_.bind_image(2);
  draw(lists, front_, rest_, to_clip, frame.projection(0, 0), frame.projection(1, 1), frame.floor[2], true);
}

void FluidThickness::draw_for_sun(const TileLists& lists, const FrameUniforms& frame) const {
  const float per_metre = 1 / frame.to_sun[3];
  draw(lists, sun_, sun_rest_, frame.world_to_sun, per_metre, per_metre, frame.floor[2], false);
}

void FluidThickness::bind_layers() const {
  front_.bind(unit::front_layer);
  rest_.bind(unit::rest_layer);
  slices_.bind(unit::layer_slices);
}

}  // namespace meniscus::render
