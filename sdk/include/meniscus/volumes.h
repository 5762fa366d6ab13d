// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Regions, and how they are filled with particles. Units as in defs.h.
#pragma once

#include <meniscus/ids.h>
#include <meniscus/types.h>

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace meniscus {

/// A box.
struct BoxRegion {
  /// m, before the pose; lower ≤ upper in every component; where they are equal it is empty
  Vec3 lower{-0.5f, -0.5f, -0.5f}, upper{0.5f, 0.5f, 0.5f};  ///< corners
};

/// About the origin, before the pose.
struct BallRegion {
  float radius = 0.5f;  ///< m, > 0
};

/// The inside of a mesh, by its winding number.
struct MeshRegion {
  std::string file;    ///< its path
  float scale = 1.0f;  ///< metres a file unit; a factor if the file states its unit, as FBX does
  /// In place of the file, which is then a name: vertices in units of `scale`, three of them a triangle.
  std::vector<Vec3> vertices{};
  std::vector<uint32_t> triangles{};  ///< three vertices each
};

/// A region that fluid can fill.
using Region = std::variant<BoxRegion, BallRegion, MeshRegion>;

/// How the particles of a volume are placed.
enum class Seeding {
  lattice,     ///< on a cubic lattice, a crystal until motion melts it
  disordered,  ///< without order and at rest density, as in water that has been stirred
};

/// A region that is filled with particles. Those nearer than half a spacing to a solid or cloth that the
/// fluid collides with are left out. So are those nearer than 0.7 spacings to an existing particle. Grains
/// are disordered: further than a spacing from solids, each is moved by up to a quarter of a spacing along
/// each axis.
///
/// With Seeding::disordered, as many particles as the free volume over s³ says fill the region, to 0.1 %
/// where the volume has more than a few thousand. They are relaxed against each other, the region's boundary,
/// solids and existing particles. The same call gives the same positions. For fluids alone.
struct FluidVolumeDef {
  FluidId fluid;                       ///< or granular material
  Region region = BoxRegion{};         ///< what to fill
  Pose pose{};                         ///< of the region
  Vec3 velocity{0, 0, 0};              ///< m/s
  Seeding seeding = Seeding::lattice;  ///< how the particles are placed
};

}  // namespace meniscus
