// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// VTK PolyData files of particles, bodies, fluids, cloth and ropes.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "sdk/io/cloth_frame.h"
#include "sdk/io/liquid_frame.h"
#include "sdk/io/particle_frame.h"
#include "sdk/io/surface_frame.h"

namespace meniscus::io {

/// Points in VTK's PolyData XML with raw appended data, for ParaView. Each particle is a vertex cell. The
/// arrays are velocity, fluid, id, density_error and pressure. Throws Error(io).
void write_vtp(const std::filesystem::path& path, const ParticleFrame& frame);

/// Points likewise, with the arrays velocity, life and kind: 0 spray, 1 foam, 2 bubble. Throws Error(io).
void write_vtp(const std::filesystem::path& path, const DiffuseFrame& frame);

/// Lists files of one of the forms above, which together are one frame: of ParticleFrame or DiffuseFrame.
/// `pieces`: relative to the folder of PATH. Throws Error(io).
template <class Frame>
void write_pvtp(const std::filesystem::path& path, std::span<const std::string> pieces);

/// Triangles in the same format, with the point array velocity. The cell array `body` or `shape` is a
/// triangle's solid, in the order of the scene. Throws Error(io).
void write_vtp(const std::filesystem::path& path, const SurfaceFrame& frame);

/// Triangles with the point arrays velocity and Normals. The cell arrays are `cloth`, a triangle's piece in
/// the order of the scene, and strain. Where the frame has texture coordinates, the cell array `texture` is u
/// and v of each corner. The point array TCoords is there as well if the texture has no seam. Throws
/// Error(io).
void write_vtp(const std::filesystem::path& path, const ClothFrame& frame);

/// Triangles with the point arrays velocity and Normals, and the cell array `fluid`, in the order of the
/// scene. Throws Error(io).
void write_vtp(const std::filesystem::path& path, const LiquidFrame& frame);

/// One polyline per rope, with the point arrays velocity and radius, as ParaView's tubes need them, and the
/// cell array `rope`. Throws Error(io).
void write_vtp(const std::filesystem::path& path, const RopeFrame& frame);

}  // namespace meniscus::io
