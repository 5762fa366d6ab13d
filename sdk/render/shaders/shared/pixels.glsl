// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// A thread a pixel of the picture.
layout(local_size_x = 16, local_size_y = 16) in;

bool is_outside(ivec2 pixel) {
  return any(greaterThanEqual(pixel, ivec2(viewport.xy)));
}
