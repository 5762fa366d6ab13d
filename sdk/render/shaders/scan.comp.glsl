// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// From how many each list has to where each starts: a prefix sum, in one group of threads.
#include "tiles.glsl"
layout(local_size_x = 256) in;
layout(location = 0) uniform uint lists;

shared uint sums[256];

void main() {
  uint self = gl_LocalInvocationID.x, share = (lists + 255u) / 256u;
  uint first = min(self * share, lists), last = min(first + share, lists);
  uint sum = 0u;
  for (uint k = first; k < last; ++k) sum += tile_cursors[k];
  sums[self] = sum;
  barrier();
  for (uint step = 1u; step < 256u; step *= 2u) {
    uint before = self >= step ? sums[self - step] : 0u;
    barrier();
    sums[self] += before;
    barrier();
  }
  uint place = self > 0u ? sums[self - 1u] : 0u;
  for (uint k = first; k < last; ++k) {
    uint size = tile_cursors[k];
    tile_starts[k] = place;
    tile_cursors[k] = place;
    place += size;
  }
  if (self == 255u) tile_starts[lists] = place;
}
