// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A copy of a world's state for the viewer.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sdk/render/renderer.h"

namespace meniscus::viewer {

/// Two snapshots with the same number are of the same world, built once.
using BuildNumber = uint32_t;

/// A copy of the visible state of a world at one moment, for another thread than the world's.
struct Snapshot {
  BuildNumber build = 0;
  std::shared_ptr<const Scene> scene;  ///< as it was built
  DeviceInfo device;
  uint64_t steps = 0;
  double time = 0;  ///< s
  StepReport step;  ///< the last one
  bool playing = false;
  std::string error;  ///< why the last step failed; empty: it succeeded

  std::optional<Vec3> held;  ///< m: place of the point that the mouse holds

  std::vector<Ellipsoid> ellipsoids;
  std::vector<Vec3> positions;   ///< m, of particles
  std::vector<Vec3> velocities;  ///< m/s, of particles
  std::vector<ParticleId> ids;   ///< of particles
  std::vector<uint32_t> fluids;  ///< of particles
  std::vector<DiffuseParticle> diffuse;
  std::vector<BodyState> bodies;
  io::ClothFrame cloth;
  io::RopeFrame ropes;

  render::ViewData view;

  render::Moment moment() const {
    return {.ellipsoids = ellipsoids,
            .fluids = fluids,
            .velocities = velocities,
            .diffuse = diffuse,
            .bodies = bodies,
            .cloth = cloth,
            .ropes = ropes,
            .view = &view};
  }
};

/// Copies the world's state. The simulation fills in the rest.
Snapshot snapshot_of(const BuiltScene& built, const Scene& scene);

}  // namespace meniscus::viewer
