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
  glEnableVertexArrayAttrib(array_, 3);
  glVertexArrayAttribFormat(array_, 3, 3, GL_FLOAT, GL_FALSE, offsetof(DiffuseParticle, velocity));
  glEnableVertexArrayAttrib(array_, 2);
  glVertexArrayAttribIFormat(array_, 2, 1, GL_UNSIGNED_INT, offsetof(DiffuseParticle, kind));
  for (const GLuint place : {0u, 1u, 2u, 3u}) glVertexArrayAttribBinding(array_, place, 0);
  glVertexArrayVertexBuffer(array_, 0, particles_.name(), 0, sizeof(DiffuseParticle));
  glVertexArrayBindingDivisor(array_, 0, 1);
}

void Foam::set(std::span<const DiffuseParticle> particles) {
  particles_.write(particles);
  count_ = static_cast<GLsizei>(particles.size());
}

void Foam::gather(const FrameUniforms& frame, const Texture& scene_distance, const Sums& sums) {
  if (count_ == 0) return;
  sums.target.use();
  for (const int k : {0, 1}) sums.target.clear_color(k, 0, 0, 0, 0);
  scene_distance.bind(unit::depth);
  gather_.use();
  glUniform2f(0, frame.projection(0, 0), frame.projection(1, 1));
  glUniform2f(1, static_cast<float>(sums.front.width()), static_cast<float>(sums.front.height()));
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glBindVertexArray(array_);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
  glDisable(GL_BLEND);
}

void Foam::lay_over(const Screen& screen, const Sums& sums, int layer) const {
  if (count_ == 0) return;
  sums.front.bind(unit::foam);
  sums.rest.bind(unit::rest_foam);
  lay_over_.use();
  glUniform1i(0, layer);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  screen.draw();
  glDisable(GL_BLEND);
}

}  // namespace meniscus::render
