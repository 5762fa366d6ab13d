// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Solids and grounds in the preview.
#pragma once

#include <meniscus/defs.h>

#include "sdk/io/preview/drawing.h"

namespace meniscus::io {

/// Adds a solid: a container by its edges and its floor, every other one by its surface. Planes are infinite
/// and not drawn here: see add_ground. May throw what solid_triangles throws.
void add_solid(Drawing& drawing, const Geometry& geometry, const Pose& pose, Vec3 up, uint32_t surface);

/// Adds a plane that faces up as a ground of tiles. Other planes add nothing. `size`: of the scene, m.
void add_ground(Drawing& drawing, const ShapeDef& shape, Vec3 up, float size);

}  // namespace meniscus::io
