// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Dispatches the shaders of caustics.
#include "sdk/render/passes/caustics.h"

namespace meniscus::render {

void Caustics::draw(const Texture& sun) const {
  Program::show_writes();
  sun.bind(unit::color);
  flatten_.use();
  glUniform2i(0, 1, 0);
  glUniform1i(1, 3);
  flatten_.run_over(half_);
  half_.bind(unit::color);
  glUniform2i(0, 0, 1);
  glUniform1i(1, 0);
  flatten_.run_over(surface_);
  surface_.bind(unit::color);
  const GLuint none = 0;
  glClearTexImage(bundles_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
  gather_.use();
  bundles_.bind_image(0, GL_READ_WRITE);
  constexpr int groups = FluidThickness::sun_size / 16;
  gather_.start(groups, groups);
  Program::show_writes();
}

}  // namespace meniscus::render
