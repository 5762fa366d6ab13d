// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Wavefront OBJ files of particles, bodies, fluids, cloth and ropes.
#pragma once

#include <filesystem>

#include "sdk/io/cloth_frame.h"
#include "sdk/io/liquid_frame.h"
#include "sdk/io/particle_frame.h"
#include "sdk/io/surface_frame.h"

namespace meniscus::io {

/// A vertex and a point element per particle, in metres. Throws Error(io).
void write_obj(const std::filesystem::path& path, const ParticleFrame& frame);

/// Likewise. Throws Error(io).
void write_obj(const std::filesystem::path& path, const DiffuseFrame& frame);

/// An object per body or shape, with its name; blanks in it become underscores. Throws Error(io).
void write_obj(const std::filesystem::path& path, const SurfaceFrame& frame);

/// An object per fluid, with the normals of its vertices. Throws Error(io).
void write_obj(const std::filesystem::path& path, const LiquidFrame& frame);

/// An object per piece of cloth, with the normals of its vertices, and texture coordinates where the frame
/// has some. Throws Error(io).
void write_obj(const std::filesystem::path& path, const ClothFrame& frame);

/// An object per rope: a line element. Throws Error(io).
void write_obj(const std::filesystem::path& path, const RopeFrame& frame);

}  // namespace meniscus::io
