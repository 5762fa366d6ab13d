// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Lists of particles, one a tile of a picture: those that may cover some of it. What covers more than a few tiles
// stands in one more list, which belongs to all of them.
layout(std430, binding = 2) restrict buffer TileStarts {
  uint tile_starts[];  // of each strand of each list, and the end of the last
};
layout(std430, binding = 3) restrict buffer TileCursors {
  uint tile_cursors[];  // how many, and then where the next goes
};
layout(std430, binding = 4) restrict buffer TileEntries {
  uint tile_entries[];
};

const uint strands = 8u;  // of each list, one behind the other: few threads at a time want the same counter

uint list_begin(int list) {
  return tile_starts[uint(list) * strands];
}
uint list_count(int list) {
  return tile_starts[(uint(list) + 1u) * strands] - list_begin(list);
}
