// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The surfaces of fluids at one moment, as the writers take them.
#pragma once

#include <meniscus/world.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace meniscus::io {

/// The surfaces of all fluids at one moment, one after the other.
struct LiquidFrame {
  double time = 0;                                 ///< s
  std::vector<Vec3> vertices;                      ///< m
  std::vector<Vec3> normals;                       ///< unit, one per vertex, out of the fluid
  std::vector<Vec3> velocities;                    ///< m/s, one per vertex
  std::vector<std::array<uint32_t, 3>> triangles;  ///< corners counter-clockwise as seen from outside
  std::vector<uint32_t> fluids;                    ///< one per triangle: its fluid, in the order of the scene
  std::vector<std::string> names;                  ///< of the fluids
};

/// The present surfaces of a world's fluids; ids and definitions in the same order. Throws what
/// World::surface_mesh throws.
LiquidFrame liquid_frame_of(const World& world, const std::vector<FluidId>& ids,
                            const std::vector<FluidDef>& defs);

}  // namespace meniscus::io
