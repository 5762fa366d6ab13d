// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Uploads and draws particles as balls.
#include "sdk/render/passes/balls.h"

#include <cstddef>

#include "sdk/render/frame/uniforms.h"

namespace meniscus::render {
namespace {

Texture texture_of(const std::vector<Vec3>& colors, GLenum filter) {
  const auto width = static_cast<GLsizei>(colors.size());
  Texture texture(GL_RGB32F, width, 1, filter);
  glTextureSubImage2D(texture.name(), 0, 0, 0, width, 1, GL_RGB, GL_FLOAT, colors.data());
  return texture;
}

std::vector<Vec3> or_water(const std::vector<Vec3>& colors) {
  return colors.empty() ? std::vector<Vec3>{FluidDef{}.color} : colors;
}

}  // namespace

Texture color_texture(ColorMap map) {
  constexpr int count = 256;
  std::vector<Vec3> colors;
  for (int i = 0; i < count; ++i) colors.push_back(color_at(map, static_cast<float>(i) / (count - 1)));
  return texture_of(colors, GL_LINEAR);
}

Balls::Balls(const std::vector<Vec3>& fluid_colors)
    : array_(make_vertex_array()),
      sequence_(color_texture(ColorMap::sequence)),
      balance_(color_texture(ColorMap::balance)),
      fluids_(texture_of(or_water(fluid_colors), GL_NEAREST)) {
  glEnableVertexArrayAttrib(array_, 0);
  glVertexArrayAttribFormat(array_, 0, 4, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(array_, 0, 0);
  glVertexArrayVertexBuffer(array_, 0, balls_.name(), 0, sizeof(Ball));
  glVertexArrayBindingDivisor(array_, 0, 1);
}

void Balls::set(std::span<const Ellipsoid> ellipsoids, const ViewData& view) {
  const bool phases = view.choice.particles == ParticleView::phase;
  colors_ = phases ? &fluids_ : view.particles.map == ColorMap::balance ? &balance_ : &sequence_;
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < view.values.size() && i < ellipsoids.size(); ++i) {
    if (!is_finite(ellipsoids[i].centre)) continue;
    const float place = phases ? (view.values[i] + 0.5f) / static_cast<float>(fluids_.width())
                               : view.particles.place(view.values[i]);
    balls.push_back({ellipsoids[i].centre, place});
  }
  balls_.write(std::span<const Ball>(balls));
  count_ = static_cast<GLsizei>(balls.size());
}

void Balls::draw(float radius) const {
  if (count_ == 0) return;
  program_.use();
  glUniform1f(0, radius);
  colors_->bind(unit::values);
  glBindVertexArray(array_);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

}  // namespace meniscus::render
