// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Puts particles into the lists of tiles, a particle a thread: the first time it counts, the second time it writes.
// Needs pixels_covered(i, strand), of the picture that the tiles are of.
layout(local_size_x = 64) in;
layout(location = 0) uniform uint count;
layout(location = 2) uniform int writes;

const int most_tiles = 9;  // see TileLists

void enter(int list, uint strand, uint i) {
  uint place = atomicAdd(tile_cursors[uint(list) * strands + strand], 1u);
  if (writes == 1) tile_entries[place] = i;
}

void main() {
  uint i = gl_GlobalInvocationID.x, strand;
  if (i >= count) return;
  ivec4 pixels = pixels_covered(i, strand);
  if (any(greaterThan(pixels.xy, pixels.zw))) return;
  ivec4 covered = pixels / tile_size;
  ivec2 size = covered.zw - covered.xy + 1;
  if (size.x * size.y > most_tiles) {
    enter(tiles.x * tiles.y, strand, i);
    return;
  }
  for (int y = covered.y; y <= covered.w; ++y) {
    for (int x = covered.x; x <= covered.z; ++x) enter(y * tiles.x + x, strand, i);
  }
}
