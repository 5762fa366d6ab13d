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

constexpr GLuint read_binding = 8, write_binding = 9;  // see shaders/fluid/fluid_depth.glsl and filter.glsl
constexpr GLuint rest_binding = 10;                    // see shaders/fluid/rest_depth.glsl

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
  for (Layer& layer : layers_) {
    for (DataBuffer* buffer : {&layer.first, &layer.second}) buffer->resize(bytes_for(width, height));
  }
}

void FluidSurface::check_room(int width, int height) {
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  if (bytes_for(width, height) <= static_cast<std::size_t>(most)) return;
  throw Error(ErrorCode::capacity, "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                                       " pixels is wanted, but the buffers of this OpenGL hold " +
                                       std::to_string(static_cast<std::size_t>(most) / sizeof(float)));
}

void FluidSurface::draw_front(const TileLists& lists, const Particles& particles,
                              const Texture& scene_distance) {
  draw(layers_[0], 0, lists, particles, scene_distance);
}

void FluidSurface::draw_rest(const TileLists& lists, const Particles& particles,
                             const Texture& scene_distance) {
  bind_front();
  draw(layers_[1], 1, lists, particles, scene_distance);
}

void FluidSurface::draw(Layer& layer, int index, const TileLists& lists, const Particles& particles,
                        const Texture& scene_distance) {
  scene_distance.bind(unit::depth);
  bind_storage(write_binding, layer.first);
  splat_.use();
  glUniform1i(1, index);
  particles.bind_motion();
  lists.start(splat_);
  layer.result = &layer.first;
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
  program.use();
  glUniform2i(0, x, y);
  glUniform1f(1, reach);
  glUniform1f(2, threshold);
  for (Layer& layer : layers_) {
    const DataBuffer& into = layer.result == &layer.first ? layer.second : layer.first;
    bind_storage(read_binding, *layer.result);
    bind_storage(write_binding, into);
    program.start(groups_for(width_, 32), groups_for(height_, 8));  // see shaders/fluid/filter.glsl
    layer.result = &into;
  }
  Program::show_writes();
}

void FluidSurface::bind_front() const {
  bind_storage(read_binding, *layers_[0].result);
}

void FluidSurface::bind_rest() const {
  bind_storage(read_binding, *layers_[1].result);
}

void FluidSurface::bind_rest_too() const {
  bind_storage(rest_binding, *layers_[1].result);
}

}  // namespace meniscus::render
