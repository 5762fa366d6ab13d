// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Particles at one moment, as the writers take them.
#pragma once

#include <meniscus/world.h>
#include <cstdint>
#include <span>

namespace meniscus::io {

/// The particles at one moment: views of arrays that live elsewhere, one element per particle.
struct ParticleFrame {
  double time = 0;                   ///< s
  std::span<const Vec3> positions;   ///< m
  std::span<const Vec3> velocities;  ///< m/s
  std::span<const ParticleId> ids;
  std::span<const uint32_t> fluids;       ///< FluidId::index
  std::span<const float> density_errors;  ///< C = ρ/ρ₀ − 1
  std::span<const float> pressures;       ///< Pa

  std::size_t size() const { return positions.size(); }
};

/// Spray, foam and bubbles, likewise.
struct DiffuseFrame {
  double time = 0;  ///< s
  std::span<const DiffuseParticle> particles;
};

/// The present particles of a world; valid until its next non-const call.
ParticleFrame frame_of(const World& world);

/// Throws Error(invalid_argument) that names the array, unless all are as long as the positions.
void check_lengths(const ParticleFrame& frame);

}  // namespace meniscus::io
