// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A pass over all pixels.
#pragma once

#include "sdk/render/gl/objects.h"

namespace meniscus::render {

/// Runs a fragment shader once per pixel; the vertex shader is screen/screen.vert.glsl.
class Screen {
 public:
  void draw() const {
    glBindVertexArray(array_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

 private:
  VertexArrayHandle array_ = make_vertex_array();
};

}  // namespace meniscus::render
