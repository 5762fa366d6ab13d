// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/world.h>
#include <cstdint>
#include <span>

namespace meniscus::io {

/// The particles at one moment, as the writers take them: views of arrays that live elsewhere, one element a
/// particle.
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

/// The world as it stands; valid until its next call that is not const.
ParticleFrame frame_of(const World& world);

/// Throws Error(invalid_argument), naming the array, unless all are as long as the positions.
void check_lengths(const ParticleFrame& frame);

}  // namespace meniscus::io
