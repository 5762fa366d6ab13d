// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// What is found of the fluid's surface in a pixel: its distance along −z, far beyond all else where there is none. The
// last bits hold how much of the filter the pixel is to get, as a share; what is negative belongs to a drop on its own.
const uint share_bits = 15u, drop_bit = 0x80000000u;
const float nothing = 1e38;

bool is_nothing_at(float found) {
  return abs(found) > 1e30;
}
int place_of(ivec2 pixel) {
  return pixel.y * int(viewport.x) + pixel.x;
}
