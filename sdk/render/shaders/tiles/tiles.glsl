// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Lists of particles, one a tile of a picture: those that may cover some of it. What covers more than a few tiles
// stands in one more list, which belongs to all of them. A list's strands follow one another.
layout(std430, binding = 2) restrict buffer TileStarts {
  uint tile_starts[];  // of each list
};
layout(std430, binding = 3) restrict buffer TileCursors {
  uint tile_cursors[];  // how many a strand has, and then where its next goes; at the end, how many there are in all
};
layout(std430, binding = 4) restrict buffer TileEntries {
  uint tile_entries[];
};

const uint strands = 16u;  // of each list

uint list_begin(int list) {
  return tile_starts[list];
}
uint list_count(int list) {
  return tile_cursors[(uint(list) + 1u) * strands - 1u] - list_begin(list);
}
