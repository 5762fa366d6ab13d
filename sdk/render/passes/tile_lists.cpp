// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Counts, allots and fills the lists of particles per tile.
#include "sdk/render/passes/tile_lists.h"

#include <utility>

namespace meniscus::render {
namespace {

/// A particle that covers more tiles is in the list of all tiles. So the capacity suffices for every view.
constexpr std::size_t most_tiles = 9;
constexpr int threads = 64;
constexpr int strands = 16;         // see shaders/tiles/tiles.glsl
constexpr GLuint next_binding = 9;  // see shaders/tiles/allot.comp.glsl

int groups_for(int count) {
  return (count + threads - 1) / threads;
}

}  // namespace

void TileLists::set(int width, int height, float radius) {
  across_ = (width + tile_size_ - 1) / tile_size_;
  down_ = (height + tile_size_ - 1) / tile_size_;
  radius_ = radius;
}

void TileLists::build(std::span<TileLists* const> all, const Particles& particles) {
  particles.bind();
  for (TileLists* lists : all) lists->reserve(particles);
  for (const TileLists* lists : all) lists->list(particles, false);
  Program::show_writes();
  for (const TileLists* lists : all) lists->allot();
  Program::show_writes();
  for (const TileLists* lists : all) lists->list(particles, true);
  Program::show_writes();
}

void TileLists::reserve(const Particles& particles) {
  starts_.reserve(sizeof(GLuint) * static_cast<std::size_t>(lists()));
  std::swap(cursors_, next_cursors_);  // allot() has cleared them
  if (cleared_ != lists()) clear_cursors();
  entries_.reserve(sizeof(GLuint) * (most_tiles * static_cast<std::size_t>(particles.count()) + 1));
}

void TileLists::clear_cursors() {
  const std::size_t count = static_cast<std::size_t>(strands) * static_cast<std::size_t>(lists()) + 1;
  for (DataBuffer* buffer : {&cursors_, &next_cursors_}) {
    buffer->reserve(sizeof(GLuint) * count);
    glClearNamedBufferData(buffer->name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  }
  cleared_ = lists();
}

void TileLists::bind() const {
  const GLuint buffers[] = {starts_.name(), cursors_.name(), entries_.name()};
  glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, 2, 3, buffers);
}

void TileLists::list(const Particles& particles, bool writes) const {
  bind();
  list_.use();
  glUniform1ui(0, static_cast<GLuint>(particles.count()));
  glUniform2i(1, across_, down_);
  glUniform1i(2, writes);
  glUniform1f(3, radius_);
  list_.start(groups_for(particles.count()));
}

void TileLists::allot() const {
  bind();
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, next_binding, next_cursors_.name());
  allot_.use();
  glUniform1ui(0, static_cast<GLuint>(lists()));
  allot_.start(groups_for(lists()));
}

void TileLists::start(const Program& program, int groups) const {
  bind();
  glUniform2i(0, across_, down_);
  program.start(groups * across_, groups * down_);
}

}  // namespace meniscus::render
