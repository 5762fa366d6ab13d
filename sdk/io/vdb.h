// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// OpenVDB files of liquids: level sets and velocities. Optional: built where OpenVDB is found.
#pragma once

#include <filesystem>

#include "sdk/io/liquid_frame.h"
#include "sdk/io/particle_frame.h"

namespace meniscus::io {

/// Throws Error(invalid_argument) if Meniscus was built without OpenVDB. It names what was missing.
void require_vdb();

/// Writes two grids a fluid: "surface" and "velocity". With several fluids each name ends with that of its
/// fluid, as in surface_water. The surface is a level set (m) in voxels of half a spacing, positive outside,
/// made of the frame's triangles. It is known within three voxels of the surface. The velocity (m/s), in
/// voxels of a spacing, is the mean of the particles within two spacings, weighted by (1 − u²)³ with u their
/// distance over that. So it is known wherever the surface is. `spacing` (m) is that of particles. Throws
/// Error(io), and what require_vdb throws.
void write_vdb(const std::filesystem::path& path, const LiquidFrame& liquid, const ParticleFrame& particles,
               float spacing);

}  // namespace meniscus::io
