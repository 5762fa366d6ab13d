// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/render/passes/fluid_thickness.h"

namespace meniscus::render {
namespace {

constexpr int sun_size = 512;

}  // namespace

FluidThickness::FluidThickness(int width, int height)
    : camera_(GL_RGBA32F, (width + 1) / 2, (height + 1) / 2, GL_LINEAR),
      sun_(GL_RGBA32F, sun_size, sun_size, GL_LINEAR),
      to_camera_({&camera_}, nullptr),
      to_sun_({&sun_}, nullptr) {}

void FluidThickness::draw(const Particles& particles, const Matrix4& to_clip, float x_per_metre,
                          float y_per_metre, float spacing, bool hides) const {
  program_.use();
  glUniformMatrix4fv(0, 1, GL_FALSE, to_clip.data());
  glUniform2f(1, x_per_metre, y_per_metre);
  glUniform1f(2, 1.6f * spacing);
  glUniform1f(3, spacing * spacing * spacing);
  glUniform1i(4, hides);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  particles.draw();
  glDisable(GL_BLEND);
}

void FluidThickness::draw_for_camera(const Particles& particles, const FrameUniforms& frame,
                                     const Texture& solid_depth, float spacing) {
  to_camera_.use();
  to_camera_.clear_color(0, 0, 0, 0, 0);
  solid_depth.bind(unit::depth);
  const Matrix4 to_clip = frame.projection * frame.view;
  draw(particles, to_clip, frame.projection(0, 0), frame.projection(1, 1), spacing, true);
}

void FluidThickness::draw_for_sun(const Particles& particles, const FrameUniforms& frame, float spacing) {
  to_sun_.use();
  to_sun_.clear_color(0, 0, 0, 0, 1);
  glBlendEquationSeparate(GL_FUNC_ADD, GL_MIN);
  const float per_metre = 1 / frame.to_sun[3];
  draw(particles, frame.world_to_sun, per_metre, per_metre, spacing, false);
  glBlendEquation(GL_FUNC_ADD);
}

}  // namespace meniscus::render
