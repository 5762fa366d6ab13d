// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// All that a run exports at one moment, as copies that outlive the world's next step.
#pragma once

#include <meniscus/bodies.h>

#include <span>
#include <vector>

#include "sdk/io/cloth_frame.h"
#include "sdk/io/liquid_frame.h"
#include "sdk/io/particle_frame.h"

namespace meniscus::io {

/// One moment of a scene. It is used again for later moments, which then take no memory.
struct SceneFrame {
  int number = 0;                           ///< of the frame
  double time = 0;                          ///< s
  std::vector<Vec3> positions, velocities;  ///< of particles, as in ParticleFrame
  std::vector<ParticleId> ids;
  std::vector<uint32_t> fluids;
  std::vector<float> density_errors, pressures;
  std::vector<DiffuseParticle> diffuse;
  std::vector<BodyState> bodies;  ///< in the order of the scene
  ClothFrame cloth;
  RopeFrame ropes;
  LiquidFrame liquid;

  /// Copies the particles of a frame, and takes its time.
  void set_particles(const ParticleFrame& frame) {
    const auto copy = [](const auto& from, auto& to) { to.assign(from.begin(), from.end()); };
    time = frame.time;
    copy(frame.positions, positions);
    copy(frame.velocities, velocities);
    copy(frame.ids, ids);
    copy(frame.fluids, fluids);
    copy(frame.density_errors, density_errors);
    copy(frame.pressures, pressures);
  }
  ParticleFrame particles() const {
    return {time, positions, velocities, ids, fluids, density_errors, pressures};
  }
  DiffuseFrame diffuse_frame() const { return {time, diffuse}; }
};

/// What a file of a whole scene has besides bodies, shapes, cloth and ropes.
struct ExportContents {
  bool particles = true;
  bool surface = false;  ///< of fluids
  bool diffuse = false;
};

}  // namespace meniscus::io
