// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Points of frames as arrays, as the writers of points and curves take them.
#pragma once

#include <meniscus/outputs.h>

#include <cstdint>
#include <span>
#include <vector>

#include "sdk/io/scene_frame.h"

namespace meniscus::io {

/// The particles of one fluid or granular material, in the order of their ids.
struct FluidPoints {
  std::vector<Vec3> positions, velocities;  ///< m and m/s
  std::vector<uint64_t> ids;
};
/// One for each of `fluids` fluids and granular materials.
std::vector<FluidPoints> points_by_fluid(const SceneFrame& frame, std::size_t fluids);

/// Spray, foam and bubbles.
struct DiffusePoints {
  std::vector<Vec3> positions, velocities;  ///< m and m/s
  std::vector<float> lives;                 ///< DiffuseParticle::life
  std::vector<uint32_t> kinds;              ///< DiffuseKind
};
DiffusePoints diffuse_points(std::span<const DiffuseParticle> particles);

/// The vertices along a rope. A closed one has its first vertex at its end too.
struct RopePoints {
  std::vector<Vec3> positions, velocities;  ///< m and m/s
};
RopePoints points_of_rope(const RopeFrame& frame, std::size_t rope);

}  // namespace meniscus::io
