// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Fills cells with points without order, at a given density.
#pragma once

#include <functional>
#include <vector>

#include "sdk/world/free_cells.h"

namespace meniscus {

/// As many points as the free cells have volume over spacing³, without order. Each pushes its neighbours away
/// by the slope of Wendland's kernel with a support of two spacings, and so do the cells that are not free.
/// So the density becomes the same everywhere. `keep_out` may move points; it is called now and then, and
/// last. The same arguments give the same points.
std::vector<Vec3> disordered_points(const FreeCells& cells, float spacing,
                                    const std::function<void(std::vector<Vec3>&)>& keep_out);

}  // namespace meniscus
