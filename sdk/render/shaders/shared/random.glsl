// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// 0 to 1, from whole numbers alone, so that every driver gives the same.
float random(ivec2 cell) {
  uint n = uint(cell.x) * 0x8da6b343u ^ uint(cell.y) * 0xd8163841u;
  n = (n ^ (n >> 15)) * 0x2c1b3c6du;
  n = (n ^ (n >> 12)) * 0x297a2d39u;
  return float(n >> 8) / 16777216.0;
}
