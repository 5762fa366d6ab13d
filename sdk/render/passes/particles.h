// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The particles of a frame in OpenGL buffers.
#pragma once

#include <meniscus/graphics.h>
#include <meniscus/world.h>

#include <optional>
#include <span>

#include "sdk/render/gl/program.h"

namespace meniscus::render {

/// The particles of a frame as arrays. Vertex shaders read one element per instance; compute shaders read
/// any.
class Particles {
 public:
  Particles();

  /// Throws Error(capacity) if OpenGL's buffers do not hold that many.
  static void check_room(std::size_t count);
  /// All have the same length; without velocities, m/s, drops are round. Particles that are not finite are
  /// not drawn.
  void set(std::span<const Ellipsoid> ellipsoids, std::span<const uint32_t> fluids,
           std::span<const Vec3> velocities = {});
  /// The particles of a world. Its own device writes them if OpenGL draws there as well; otherwise they are
  /// copied through the host.
  void set(const World& world);
  /// Draws four corners per particle.
  void draw() const;
  /// Binds them for compute shaders, see shaders/particles/particles.glsl.
  void bind() const;
  /// Binds velocities for shaders/particles/motion.glsl; the program that reads them must be in use.
  void bind_motion() const;
  GLsizei count() const { return count_; }

 private:
  bool share(const World& world);

  DataBuffer ellipsoids_, fluids_, velocities_;
  bool has_velocities_ = false;
  std::optional<GlParticles> shared_;  // these buffers, while they are large enough
  std::size_t room_ = 0;               // capacity of the shared buffers, in particles
  bool can_share_ = true;              // until sharing fails
  VertexArrayHandle array_;
  GLsizei count_ = 0;
};

}  // namespace meniscus::render
