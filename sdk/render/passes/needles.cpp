// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Uploads and draws needles.
#include "sdk/render/passes/needles.h"

#include <cstddef>

namespace meniscus::render {

Needles::Needles() : array_(make_vertex_array()) {
  const std::size_t offsets[] = {offsetof(Needle, from), offsetof(Needle, to), offsetof(Needle, color)};
  for (GLuint place = 0; place < 3; ++place) {
    glEnableVertexArrayAttrib(array_, place);
    glVertexArrayAttribFormat(array_, place, 3, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offsets[place]));
    glVertexArrayAttribBinding(array_, place, 0);
  }
  glVertexArrayVertexBuffer(array_, 0, needles_.name(), 0, sizeof(Needle));
  glVertexArrayBindingDivisor(array_, 0, 1);
}

void Needles::set(std::span<const Needle> needles) {
  needles_.write(needles);
  count_ = static_cast<GLsizei>(needles.size());
}

void Needles::draw(float pixels) const {
  if (count_ == 0) return;
  program_.use();
  glUniform1f(0, pixels);
  glBindVertexArray(array_);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

}  // namespace meniscus::render
