// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Draws spray, foam and bubbles.
#include "sdk/render/passes/foam.h"

#include <cstddef>

namespace meniscus::render {

Foam::Foam() : array_(make_vertex_array()) {
  glEnableVertexArrayAttrib(array_, 0);
  glVertexArrayAttribFormat(array_, 0, 3, GL_FLOAT, GL_FALSE, offsetof(DiffuseParticle, position));
  glEnableVertexArrayAttrib(array_, 1);
  glVertexArrayAttribFormat(array_, 1, 1, GL_FLOAT, GL_FALSE, offsetof(DiffuseParticle, life));
  glEnableVertexArrayAttrib(array_, 2);
  glVertexArrayAttribIFormat(array_, 2, 1, GL_UNSIGNED_INT, offsetof(DiffuseParticle, kind));
  for (const GLuint place : {0u, 1u, 2u}) glVertexArrayAttribBinding(array_, place, 0);
  glVertexArrayVertexBuffer(array_, 0, particles_.name(), 0, sizeof(DiffuseParticle));
  glVertexArrayBindingDivisor(array_, 0, 1);
}

void Foam::set(std::span<const DiffuseParticle> particles) {
  particles_.write(particles);
  count_ = static_cast<GLsizei>(particles.size());
}

void Foam::gather(const FrameUniforms& frame, const Texture& scene_distance, float spacing,
                  const Target& to_sums) {
  if (count_ == 0) return;
  to_sums.use();
  to_sums.clear_color(0, 0, 0, 0, 0);
  scene_distance.bind(unit::depth);
  gather_.use();
  glUniform2f(0, frame.projection(0, 0), frame.projection(1, 1));
  glUniform1f(1, spacing);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glBindVertexArray(array_);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
  glDisable(GL_BLEND);
}

void Foam::lay_over(const Screen& screen, const Texture& sums) const {
  if (count_ == 0) return;
  sums.bind(unit::color);
  lay_over_.use();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  screen.draw();
  glDisable(GL_BLEND);
}

}  // namespace meniscus::render
