// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Dispatches the shaders that draw and filter the fluid's depth.
#include "sdk/render/passes/fluid_surface.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "sdk/render/frame/uniforms.h"

namespace meniscus::render {

namespace {

constexpr GLuint read_binding = 8, write_binding = 9;  // see shaders/fluid/found.glsl

void bind_storage(GLuint binding, const DataBuffer& buffer) {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer.name());
}

std::size_t bytes_for(int width, int height) {
  return sizeof(float) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

int groups_for(int count, int size) {
  return (count + size - 1) / size;
}

}  // namespace

FluidSurface::FluidSurface(int width, int height) : width_(width), height_(height) {
  for (DataBuffer* buffer : {&first_, &second_}) buffer->resize(bytes_for(width, height));
}

void FluidSurface::check_room(int width, int height) {
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  if (bytes_for(width, height) <= static_cast<std::size_t>(most)) return;
  throw Error(ErrorCode::capacity, "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                                       " pixels is wanted, but the buffers of this OpenGL hold " +
                                       std::to_string(static_cast<std::size_t>(most) / sizeof(float)));
}

void FluidSurface::draw(const TileLists& lists, const Texture& scene_distance) {
  scene_distance.bind(unit::depth);
  bind_storage(write_binding, first_);
  splat_.use();
  lists.start(splat_);
  result_ = &first_;
}

void FluidSurface::filter(SurfaceFilter filter, float reach, float threshold, float pixels) {
  if (filter == SurfaceFilter::none) return;
  if (filter == SurfaceFilter::curvature_flow) {
    // Each step spreads depths by √0.4 pixels.
    const int steps = std::clamp(static_cast<int>(pixels * pixels / 0.4f), 1, 120);
    for (int k = 0; k < steps; ++k) apply(curvature_flow_, 1, 0, reach, threshold);
    return;
  }
  const Program& program = filter == SurfaceFilter::bilateral ? bilateral_ : narrow_range_;
  // Filtering the axes one after the other leaves streaks. The second round, half as wide, removes them.
  for (const float share : {1.0f, 0.5f}) {
    apply(program, 1, 0, share * reach, threshold);
    apply(program, 0, 1, share * reach, threshold);
  }
}

void FluidSurface::apply(const Program& program, int x, int y, float reach, float threshold) {
  const DataBuffer& into = result_ == &first_ ? second_ : first_;
  bind();
  bind_storage(write_binding, into);
  program.use();
  glUniform2i(0, x, y);
  glUniform1f(1, reach);
  glUniform1f(2, threshold);
  program.start(groups_for(width_, 32), groups_for(height_, 8));  // see shaders/fluid/filter.glsl
  Program::show_writes();
  result_ = &into;
}

void FluidSurface::bind() const {
  bind_storage(read_binding, *result_);
}

}  // namespace meniscus::render
