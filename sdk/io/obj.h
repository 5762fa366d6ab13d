// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "sdk/io/particle_frame.h"
#include "sdk/io/surface_frame.h"

namespace meniscus::io {

/// A vertex and a point element a particle, in metres. Throws Error(io).
void write_obj(const std::filesystem::path& path, const ParticleFrame& frame);

/// An object a body, under its name; blanks in it become underscores. Throws Error(io).
void write_obj(const std::filesystem::path& path, const SurfaceFrame& frame);

}  // namespace meniscus::io
