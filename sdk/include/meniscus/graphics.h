// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Particles for a renderer that draws on the GPU that simulates, with no way through the host.
#pragma once

#include <cstdint>
#include <memory>

namespace meniscus {

/// Two buffers of OpenGL's that worlds on CUDA write their particles to: see World::write_particles. The
/// context that has them must be current wherever this is made, used and destroyed; they must outlive it, and
/// keep their storage.
class GlParticles {
 public:
  /// By the names that OpenGL gave them: 40 bytes a particle as Ellipsoid has them, and 4 for FluidId::index.
  /// Throws Error(device) where CUDA is not there, or cannot share them, as where another device draws than
  /// the one that simulates.
  GlParticles(uint32_t ellipsoids, uint32_t fluids);
  ~GlParticles();
  GlParticles(GlParticles&&) noexcept;
  GlParticles& operator=(GlParticles&&) noexcept;

 private:
  friend class World;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace meniscus
