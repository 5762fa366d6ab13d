// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Streaks in a drawn surface: how rough its normals are along the pixels' rows and columns, and between them.
#pragma once

#include <array>
#include <vector>

namespace meniscus::cli {

/// Normals in view space and the distance, row by row; a distance of 0 is no fluid.
struct NormalPicture {
  int width = 0, height = 0;
  std::vector<std::array<float, 4>> pixels;
};

/// How fast normals turn to and fro: root mean square of |n(−d) − 2 n(0) + n(d)| in degrees, over offsets d
/// of 5 pixels. A filter that works along rows and columns leaves streaks there. Without streaks, and for a
/// shape without a direction, both values agree.
struct Roughness {
  double axes = 0;         ///< d along a row or a column
  double between = 0;      ///< d of 3 pixels one way and 4 the other
  std::size_t places = 0;  ///< that count

  double ratio() const { return between > 0 ? axes / between : 1; }
};

/// Places where the distance changes by more than `threshold`, in metres, over d are between surfaces, and
/// are left out.
Roughness roughness_of(const NormalPicture& picture, float threshold);

}  // namespace meniscus::cli
