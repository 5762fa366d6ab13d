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

/// A filter that works along rows and columns leaves streaks there. Without streaks both values agree.
struct Roughness {
  double axes = 0;     ///< degrees, RMS between normals 5 pixels apart along a row or a column
  double between = 0;  ///< degrees, RMS between normals 3 pixels apart one way and 4 the other
  std::size_t pairs = 0;

  double streaks() const { return between > 0 ? axes / between : 1; }
};

/// Pairs whose distances differ by more than `threshold`, in metres, are of different surfaces and left out.
Roughness roughness_of(const NormalPicture& picture, float threshold);

}  // namespace meniscus::cli
