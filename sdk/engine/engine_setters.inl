// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// DeviceEngine's calls that set positions and velocities of particles.
#pragma once

#include "sdk/engine/engine.inl"
#include "sdk/engine/setter_kernels.h"

namespace meniscus {

/// What sets and crowds know of all particles is forgotten: neighbours of the moved ones are elsewhere too.
template <class D>
void DeviceEngine<D>::place_particles(std::span<const uint32_t> slots, std::span<const Vec3> positions) {
  const uint32_t count = particles_.sorted();
  pbd::Buffer<uint32_t> numbers(device_, "placed particles");
  pbd::Buffer<Vec3> places(device_, "places");
  replace(numbers, slots);
  replace(places, positions);
  device_.monitor().commit();
  device_.parallel_for("particles/place", count,
                       engine_kernels::PlaceParticles{particles_.position.current.view(),
                                                      particles_.phase.current.view(),
                                                      particles_.slot.current.view(),
                                                      {numbers.view(), places.view()}});
  any_overlapping_ = true;
  solver_.particles_changed(0, count);
  density_.note_placed(0, count);
}

template <class D>
void DeviceEngine<D>::set_particle_velocities(std::span<const uint32_t> slots,
                                              std::span<const Vec3> velocities) {
  pbd::Buffer<uint32_t> numbers(device_, "particles");
  pbd::Buffer<Vec3> values(device_, "velocities");
  replace(numbers, slots);
  replace(values, velocities);
  device_.parallel_for("particles/velocities", particles_.sorted(),
                       engine_kernels::SetVelocities{particles_.velocity.current.view(),
                                                     particles_.slot.current.view(),
                                                     {numbers.view(), values.view()}});
  solver_.particles_changed(0, 0);
}

}  // namespace meniscus
