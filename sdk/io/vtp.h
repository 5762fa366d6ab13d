// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "sdk/io/particle_frame.h"
#include "sdk/io/surface_frame.h"

namespace meniscus::io {

/// Points in VTK's PolyData XML with raw appended data, for ParaView: a vertex cell a particle, and the
/// arrays velocity, fluid, id, density_error and pressure. Throws Error(io).
void write_vtp(const std::filesystem::path& path, const ParticleFrame& frame);

/// Triangles in the same format, with the cell array `body`: a triangle's body, in the order of the scene.
/// Throws Error(io).
void write_vtp(const std::filesystem::path& path, const SurfaceFrame& frame);

}  // namespace meniscus::io
