// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Uploads and draws triangles.
#include "sdk/render/meshes/mesh.h"

#include <cstddef>

namespace meniscus::render {

Mesh::Mesh() : array_(make_vertex_array()) {
  const auto attribute = [&](GLuint place, GLint components, std::size_t offset) {
    glEnableVertexArrayAttrib(array_, place);
    glVertexArrayAttribFormat(array_, place, components, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(array_, place, 0);
  };
  attribute(0, 3, offsetof(Vertex, position));
  attribute(1, 3, offsetof(Vertex, normal));
  attribute(2, 4, offsetof(Vertex, color));
  attribute(3, 2, offsetof(Vertex, place));
  glVertexArrayVertexBuffer(array_, 0, vertices_.name(), 0, sizeof(Vertex));
}

void Mesh::set(const Triangles& triangles) {
  vertices_.write(std::span(triangles));
  count_ = static_cast<GLsizei>(triangles.size());
}

void Mesh::draw() const {
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLES, 0, count_);
}

}  // namespace meniscus::render
