// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sdk/render/renderer.h"

namespace meniscus::viewer {

/// Two snapshots with the same number are of the same world, built once.
using BuildNumber = uint32_t;

/// A copy of all that is to be seen of a world at one moment, for another thread than the world's.
struct Snapshot {
  BuildNumber build = 0;
  std::shared_ptr<const Scene> scene;  ///< as it was built
  DeviceInfo device;
  uint64_t steps = 0;
  double time = 0;  ///< s
  StepReport step;  ///< the last one
  bool playing = false;
  std::string error;  ///< why the last step failed; empty: it did not

  std::optional<Vec3> held;  ///< m: where what the mouse holds is

  std::vector<Ellipsoid> ellipsoids;
  std::vector<Vec3> positions;   ///< m, of particles
  std::vector<ParticleId> ids;   ///< likewise
  std::vector<uint32_t> fluids;  ///< likewise
  std::vector<DiffuseParticle> diffuse;
  std::vector<BodyState> bodies;
  io::ClothFrame cloth;
  io::RopeFrame ropes;

  render::ViewData view;

  render::Moment moment() const {
    return {.ellipsoids = ellipsoids,
            .fluids = fluids,
            .diffuse = diffuse,
            .bodies = bodies,
            .cloth = cloth,
            .ropes = ropes,
            .view = &view};
  }
};

/// Of the world alone; what the simulation knows beside it is left to fill in.
Snapshot snapshot_of(const BuiltScene& built, const Scene& scene);

}  // namespace meniscus::viewer
