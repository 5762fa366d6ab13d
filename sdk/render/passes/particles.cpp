// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/render/passes/particles.h"

#include <cstddef>
#include <vector>

#include "pbd/math/vec.h"

namespace meniscus::render {

Particles::Particles() : array_(make_vertex_array()) {
  const auto attribute = [&](GLuint place, GLint components, std::size_t offset) {
    glEnableVertexArrayAttrib(array_, place);
    glVertexArrayAttribFormat(array_, place, components, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(array_, place, 0);
  };
  attribute(0, 3, offsetof(Ellipsoid, centre));
  attribute(1, 3, offsetof(Ellipsoid, radii));
  attribute(2, 4, offsetof(Ellipsoid, rotation));
  glEnableVertexArrayAttrib(array_, 3);
  glVertexArrayAttribIFormat(array_, 3, 1, GL_UNSIGNED_INT, 0);
  glVertexArrayAttribBinding(array_, 3, 1);
  glVertexArrayVertexBuffer(array_, 0, ellipsoids_.name(), 0, sizeof(Ellipsoid));
  glVertexArrayVertexBuffer(array_, 1, fluids_.name(), 0, sizeof(uint32_t));
  for (const GLuint binding : {0u, 1u}) glVertexArrayBindingDivisor(array_, binding, 1);
}

void Particles::set(std::span<const Ellipsoid> ellipsoids, std::span<const uint32_t> fluids) {
  std::vector<Ellipsoid> shown;
  std::vector<uint32_t> theirs;
  shown.reserve(ellipsoids.size());
  theirs.reserve(ellipsoids.size());
  for (std::size_t i = 0; i < ellipsoids.size(); ++i) {
    const Ellipsoid& e = ellipsoids[i];
    if (!is_finite(e.centre) || !is_finite(e.radii)) continue;
    shown.push_back(e);
    theirs.push_back(fluids[i]);
  }
  ellipsoids_.write(std::span<const Ellipsoid>(shown));
  fluids_.write(std::span<const uint32_t>(theirs));
  count_ = static_cast<GLsizei>(shown.size());
}

void Particles::draw() const {
  glBindVertexArray(array_);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

}  // namespace meniscus::render
