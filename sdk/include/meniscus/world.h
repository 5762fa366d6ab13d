// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/defs.h>
#include <meniscus/error.h>
#include <meniscus/ids.h>
#include <meniscus/outputs.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace meniscus {

/// One simulated world on one device. Worlds share nothing; a world is used by one thread at a time.
/// Every call may throw Error, and has then changed nothing.
class World {
 public:
  explicit World(const WorldDef& def = {});
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  const WorldDef& def() const;
  /// "cpu" or "cuda", the device's name, and, where `automatic` fell back to the CPU, the reason.
  DeviceInfo device() const;
  float support_radius() const;           ///< h, m
  float particle_mass(FluidId id) const;  ///< kg

  FluidId create_fluid(const FluidDef& def);
  ShapeId create_shape(const ShapeDef& def);
  void destroy_shape(ShapeId id);
  SinkId create_sink(const SinkDef& def);
  void destroy_sink(SinkId id);
  ProbeId create_probe(const ProbeDef& def);
  void destroy_probe(ProbeId id);

  /// Fills a region; returns how many particles were made.
  std::size_t add_fluid(const FluidVolumeDef& def);
  /// One particle a position, none left out; velocities may be empty (at rest), else as many. Returns the
  /// first id: the rest follow on.
  ParticleId add_particles(FluidId fluid, std::span<const Vec3> positions,
                           std::span<const Vec3> velocities = {});
  /// Unknown ids are an error.
  void remove_particles(std::span<const ParticleId> ids);
  /// Lets the particles find their rest density with no motion kept: takes the energy out of overlaps.
  void relax(int iterations = 50);

  /// Advances by dt seconds. On Error(non_finite) the state is the one before the call.
  StepReport step(float dt);
  double time() const;  ///< s

  std::size_t particle_count() const;
  // Read-outs, one element a particle in the order of the ids; valid until the next call that is not const.
  std::span<const ParticleId> ids() const;
  std::span<const Vec3> positions() const;        ///< m
  std::span<const Vec3> velocities() const;       ///< m/s
  std::span<const uint32_t> fluids() const;       ///< FluidId::index
  std::span<const float> density_errors() const;  ///< C = ρ/ρ₀ − 1, measured afresh
  std::span<const float> pressures() const;       ///< Pa, of the last substep

  Diagnostics diagnostics() const;
  double probe(ProbeId id) const;  ///< unit by its kind; of the last step
  /// Over positions and velocities in the order of the ids: equal for equal bits.
  uint64_t state_hash() const;
  std::size_t device_bytes() const;  ///< held on the device

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace meniscus
