// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Uploads particles, or shares their buffers with CUDA.
#include "sdk/render/passes/particles.h"

#include <meniscus/error.h>

#include <cstddef>

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

void Particles::set(std::span<const Ellipsoid> ellipsoids, std::span<const uint32_t> fluids,
                    std::span<const Vec3> velocities) {
  shared_.reset();
  ellipsoids_.write(ellipsoids);
  fluids_.write(fluids);
  count_ = static_cast<GLsizei>(ellipsoids.size());
  has_velocities_ = !velocities.empty();
  velocities_.write(velocities);
}

void Particles::set(const World& world) {
  if (!share(world)) return set(world.ellipsoids(), world.fluids(), world.velocities());
  world.write_particles(*shared_);
  count_ = static_cast<GLsizei>(world.particle_count());
  has_velocities_ = true;
}

void Particles::check_room(std::size_t count) {
  // An ellipsoid takes more memory than a particle's entry in TileLists.
  GLint64 bytes = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  const std::size_t most = static_cast<std::size_t>(bytes) / sizeof(Ellipsoid);
  if (count <= most) return;
  throw Error(ErrorCode::capacity, std::to_string(count) +
                                       " particles are to be drawn, but the buffers of this OpenGL hold " +
                                       std::to_string(most));
}

/// Whether the buffers can be written by the world's device, and have room.
bool Particles::share(const World& world) {
  const std::size_t count = world.particle_count();
  if (!can_share_ || count == 0 || world.device().kind != "cuda") return false;
  if (shared_ && count <= room_) return true;
  shared_.reset();
  room_ = count + count / 4;
  ellipsoids_.resize(room_ * sizeof(Ellipsoid));
  fluids_.resize(room_ * sizeof(uint32_t));
  velocities_.resize(room_ * sizeof(Vec3));
  try {
    shared_.emplace(ellipsoids_.name(), fluids_.name(), velocities_.name());
  } catch (const Error&) {
    can_share_ = false;  // OpenGL draws on another device
  }
  return can_share_;
}

void Particles::draw() const {
  glBindVertexArray(array_);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

void Particles::bind_motion() const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 11, velocities_.name());
  glUniform1i(2, has_velocities_);
}

void Particles::bind() const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, ellipsoids_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, fluids_.name());
}

}  // namespace meniscus::render
