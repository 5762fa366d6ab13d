// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// From how many each strand of a list has to where it starts. Which list comes first is left to chance.
#include "tiles/tiles.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 9) writeonly restrict buffer NextCursors {
  uint next_cursors[];  // of the next picture, which begins with 0
};
layout(location = 0) uniform uint lists;

void main() {
  uint list = gl_GlobalInvocationID.x, first = list * strands, size = 0u;
  if (list >= lists) return;
  if (list == 0u) next_cursors[lists * strands] = 0u;
  for (uint k = first; k < first + strands; ++k) size += tile_cursors[k];
  uint place = size > 0u ? atomicAdd(tile_cursors[lists * strands], size) : 0u;
  tile_starts[list] = place;
  for (uint k = first; k < first + strands; ++k) {
    uint next = place + tile_cursors[k];
    tile_cursors[k] = place;
    next_cursors[k] = 0u;
    place = next;
  }
}
