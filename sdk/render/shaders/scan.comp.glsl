// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// From how many each strand of a list has to where it starts: a prefix sum, in one group of threads.
#include "tiles.glsl"
layout(local_size_x = 1024) in;
layout(location = 0) uniform uint counters;

shared uint sums[1024];

void main() {
  uint self = gl_LocalInvocationID.x, share = (counters + 1023u) / 1024u;
  uint first = min(self * share, counters), last = min(first + share, counters);
  uint sum = 0u;
  for (uint k = first; k < last; ++k) sum += tile_cursors[k];
  sums[self] = sum;
  barrier();
  for (uint step = 1u; step < 1024u; step *= 2u) {
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
  if (self == 1023u) tile_starts[counters] = place;
}
