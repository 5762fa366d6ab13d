// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/graphics.h>
#include <meniscus/world.h>

#include <optional>
#include <span>

#include "sdk/render/gl/program.h"

namespace meniscus::render {

/// The particles of a frame, as arrays that vertex shaders read one element an instance of, and compute
/// shaders as they like.
class Particles {
 public:
  Particles();

  /// Throws Error(capacity) where OpenGL's buffers do not hold so many.
  static void check_room(std::size_t count);
  /// Equally many of both. Those that are not finite are not drawn.
  void set(std::span<const Ellipsoid> ellipsoids, std::span<const uint32_t> fluids);
  /// Those of a world: written by its own device where that draws as well, else by way of the host.
  void set(const World& world);
  /// Four corners each.
  void draw() const;
  /// For compute shaders, see shaders/particles/particles.glsl.
  void bind() const;
  GLsizei count() const { return count_; }

 private:
  bool share(const World& world);

  DataBuffer ellipsoids_, fluids_;
  std::optional<GlParticles> shared_;  // these buffers, while they have room
  std::size_t room_ = 0;               // of what is shared, particles
  bool can_share_ = true;              // as far as is known
  VertexArrayHandle array_;
  GLsizei count_ = 0;
};

}  // namespace meniscus::render
