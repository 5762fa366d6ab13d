// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The contents of a mesh file that has one part and no materials.
#pragma once

#include <meniscus/types.h>

#include <cstdint>
#include <vector>

namespace meniscus::collision {

struct Polygons {
  std::vector<Vec3> vertices;     ///< in file units
  std::vector<uint32_t> corners;  ///< vertices of all polygons, one polygon after the other
  std::vector<uint32_t> ends;     ///< by polygon: the end of its corners. Each has three or more.
};

}  // namespace meniscus::collision
