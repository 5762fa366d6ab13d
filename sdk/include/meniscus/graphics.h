// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Particles for a renderer on the GPU that simulates, without a copy through the host.
#pragma once

#include <cstdint>
#include <memory>

namespace meniscus {

/// OpenGL buffers that worlds on CUDA write their particles to: see World::write_particles. The context of
/// the buffers must be current wherever this object is created, used and destroyed. The buffers must outlive
/// it and keep their storage.
class GlParticles {
 public:
  /// Takes the OpenGL names of buffers: one of 40 bytes a particle for Ellipsoid, one of 4 bytes a particle
  /// for FluidId::index, and one of 12 bytes a particle for velocities, m/s. Without the last, which 0 means,
  /// velocities are not written. Throws Error(device) without CUDA, or if CUDA cannot share the buffers, as
  /// when one device draws and another simulates.
  GlParticles(uint32_t ellipsoids, uint32_t fluids, uint32_t velocities = 0);
  ~GlParticles();
  GlParticles(GlParticles&&) noexcept;             ///< takes the buffers of another
  GlParticles& operator=(GlParticles&&) noexcept;  ///< likewise

 private:
  friend class World;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace meniscus
