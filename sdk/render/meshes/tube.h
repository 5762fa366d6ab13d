// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tubes along lines of points, for ropes.
#pragma once

#include <span>

#include "sdk/render/meshes/mesh.h"

namespace meniscus::render {

/// Adds a round tube along a line of points, with flat ends. A line that ends where it began is closed.
void add_tube(Triangles& triangles, std::span<const Vec3> line, float radius, Float4 color);

}  // namespace meniscus::render
