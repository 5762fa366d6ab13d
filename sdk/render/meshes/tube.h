// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sdk/render/meshes/mesh.h"

namespace meniscus::render {

/// Adds a round tube along a line of points, with flat ends; a line that ends where it began is closed.
void add_tube(Triangles& triangles, std::span<const Vec3> line, float radius, Float4 color);

}  // namespace meniscus::render
