// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth and ropes in the preview.
#pragma once

#include <span>

#include "sdk/io/cloth_frame.h"
#include "sdk/io/preview/drawing.h"

namespace meniscus::io {

/// Adds cloth, shaded smoothly with the normals of its vertices, and darker at the back. `colors` are those
/// of the pieces, linear RGB; a piece beyond the end has ClothDef's. Triangles that are not finite are left
/// out.
void add_cloth(Drawing& drawing, const ClothFrame& frame, std::span<const Vec3> colors);

/// Adds ropes as tubes, likewise.
void add_ropes(Drawing& drawing, const RopeFrame& frame, std::span<const Vec3> colors);

}  // namespace meniscus::io
