// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Points spread evenly over a surface.
#pragma once

#include <vector>

#include "collision/mesh/mesh.h"

namespace meniscus {

struct SurfaceSample {
  Vec3 position;  ///< m
  Vec3 normal;    ///< unit, of its triangle
};

double surface_area(const collision::TriangleMesh& mesh);  ///< m²

/// `count` points with large mutual distances: the most crowded of five times as many random points are
/// eliminated (Yuksel 2015). The two sides of a thin sheet do not crowd one another. The same mesh gives the
/// same points.
std::vector<SurfaceSample> spread_samples(const collision::TriangleMesh& mesh, uint32_t count);

}  // namespace meniscus
