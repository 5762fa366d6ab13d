// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Binary PLY files of particles, bodies, fluids, cloth and ropes.
#pragma once

#include <filesystem>

#include "sdk/io/cloth_frame.h"
#include "sdk/io/liquid_frame.h"
#include "sdk/io/particle_frame.h"
#include "sdk/io/surface_frame.h"

namespace meniscus::io {

/// Points in binary little-endian PLY, for Blender, MeshLab and assimp. A vertex has x y z (m), vx vy vz
/// (m/s), fluid, id and density_error. Throws Error(io), and Error(capacity) for an id beyond the 32 bits of
/// a PLY integer.
void write_ply(const std::filesystem::path& path, const ParticleFrame& frame);

/// Likewise. A vertex has x y z (m), vx vy vz (m/s), life (s) and kind: 0 spray, 1 foam, 2 bubble. Throws
/// Error(io).
void write_ply(const std::filesystem::path& path, const DiffuseFrame& frame);

/// Triangles in the same format. A vertex has x y z (m) and vx vy vz (m/s); a face also has `body` or
/// `shape`, its solid in the order of the scene. Throws Error(io).
void write_ply(const std::filesystem::path& path, const SurfaceFrame& frame);

/// Triangles likewise. A vertex has x y z (m), nx ny nz and vx vy vz (m/s); a face also has `cloth`, its
/// piece in the order of the scene, and its `strain`. Where the frame has texture coordinates, a face has
/// `texcoord`: u and v of each corner. Throws Error(io).
void write_ply(const std::filesystem::path& path, const ClothFrame& frame);

/// Triangles likewise. A vertex has x y z (m), nx ny nz and vx vy vz (m/s); a face also has `fluid`, its
/// fluid in the order of the scene. Throws Error(io).
void write_ply(const std::filesystem::path& path, const LiquidFrame& frame);

/// Edges likewise. A vertex has x y z (m), vx vy vz (m/s) and the radius (m); an edge also has `rope`, its
/// rope in the order of the scene. Throws Error(io).
void write_ply(const std::filesystem::path& path, const RopeFrame& frame);

}  // namespace meniscus::io
