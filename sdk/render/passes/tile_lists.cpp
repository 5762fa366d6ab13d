// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/render/passes/tile_lists.h"

namespace meniscus::render {
namespace {

/// What covers more stands in the list of all tiles: so there is room for all, whatever is to be seen.
constexpr std::size_t most_tiles = 9;
constexpr int threads = 64;
constexpr int strands = 8;  // see shaders/tiles.glsl

}  // namespace

void TileLists::build(const Particles& particles, int width, int height, float radius) {
  across_ = (width + tile_size_ - 1) / tile_size_;
  down_ = (height + tile_size_ - 1) / tile_size_;
  const int counters = strands * (across_ * down_ + 1);
  const std::size_t count = static_cast<std::size_t>(particles.count());
  starts_.reserve(sizeof(GLuint) * (static_cast<std::size_t>(counters) + 1));
  cursors_.reserve(sizeof(GLuint) * static_cast<std::size_t>(counters));
  entries_.reserve(sizeof(GLuint) * (most_tiles * count + 1));
  glClearNamedBufferData(cursors_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  particles.bind();
  const GLuint buffers[] = {starts_.name(), cursors_.name(), entries_.name()};
  glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, 2, 3, buffers);
  for (const int writes : {0, 1}) {
    list_.use();
    glUniform1ui(0, static_cast<GLuint>(count));
    glUniform2i(1, across_, down_);
    glUniform1i(2, writes);
    glUniform1f(3, radius);
    list_.run((particles.count() + threads - 1) / threads);
    if (writes) break;
    scan_.use();
    glUniform1ui(0, static_cast<GLuint>(counters));
    scan_.run(1);
  }
}

void TileLists::run(const Program& program) const {
  const GLuint buffers[] = {starts_.name(), cursors_.name(), entries_.name()};
  glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, 2, 3, buffers);
  glUniform2i(0, across_, down_);
  program.run(across_, down_);
}

}  // namespace meniscus::render
