// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/defs.h>

#include <vector>

#include "collision/shape.h"
#include "sdk/engine/engine.h"

namespace meniscus {

/// What a ShapeDef becomes: one shape, or a container's planes.
struct ShapeParts {
  std::vector<collision::Shape> shapes;  ///< first_opening counts within `openings`
  std::vector<collision::PlaneOpening> openings;
};

/// Builds the parts, with their fields in the engine. `spacing` and `reach` set a mesh field's cell size and
/// margin.
ShapeParts make_shape_parts(const ShapeDef& def, Engine& engine, float spacing, float reach);

}  // namespace meniscus
