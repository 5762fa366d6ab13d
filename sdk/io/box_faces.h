// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The corners and faces of a box.
#pragma once

#include <meniscus/types.h>

namespace meniscus::io {

/// A corner of a box: bits 0, 1 and 2 of the number give its side in x, y and z.
inline Vec3 box_corner(Vec3 half, int number) {
  return {number & 1 ? half.x : -half.x, number & 2 ? half.y : -half.y, number & 4 ? half.z : -half.z};
}

/// The corners of each face, in the order of enum Face, counter-clockwise as seen from outside.
inline constexpr int box_face_corners[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                               {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
inline constexpr Vec3 box_face_normals[6] = {{-1, 0, 0}, {1, 0, 0},  {0, -1, 0},
                                             {0, 1, 0},  {0, 0, -1}, {0, 0, 1}};

}  // namespace meniscus::io
