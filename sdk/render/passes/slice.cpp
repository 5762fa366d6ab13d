// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Uploads and draws the slice of distances.
#include "sdk/render/passes/slice.h"

#include "sdk/render/frame/uniforms.h"
#include "sdk/render/passes/balls.h"

namespace meniscus::render {
namespace {

void set_vector(GLint place, Vec3 v) {
  glUniform3f(place, v.x, v.y, v.z);
}

}  // namespace

Texture Slice::balance_colors() {
  return color_texture(ColorMap::balance);
}

void Slice::set(const DistanceSlice& slice, const Scale& scale) {
  place_ = {slice.corner, slice.across, slice.up, slice.columns, slice.rows, {}};
  scale_ = scale;
  values_.emplace(GL_R32F, slice.columns, slice.rows, GL_LINEAR);
  glTextureSubImage2D(values_->name(), 0, 0, 0, slice.columns, slice.rows, GL_RED, GL_FLOAT,
                      slice.distances.data());
}

void Slice::draw() const {
  if (!values_) return;
  program_.use();
  set_vector(0, place_.corner);
  set_vector(1, place_.across);
  set_vector(2, place_.up);
  glUniform2f(3, scale_.low, scale_.high);
  colors_.bind(unit::values);
  values_->bind(unit::distances);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisable(GL_BLEND);
}

}  // namespace meniscus::render
