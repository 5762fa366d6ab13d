// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// What is found of the fluid's surface in a pixel: its distance along −z, far beyond all else where there is none. The
// last bits hold how much of the filter the pixel is to get, as a share; what is negative belongs to a drop on its own.
// The surface of the rest goes on as the first surface where there is no rest, so that filters and normals find what is
// next to it; the share is 0 there, and nothing else has that.
const uint share_bits = 15u, drop_bit = 0x80000000u;
const float nothing = 1e38;

bool is_nothing_at(float found) {
  return abs(found) > 1e30;
}
bool has_share(float found) {
  return !is_nothing_at(found) && (floatBitsToUint(found) & share_bits) != 0u;
}
float without_share(float found) {
  return is_nothing_at(found) ? found : uintBitsToFloat(floatBitsToUint(found) & ~share_bits);
}
int place_of(ivec2 pixel) {
  return pixel.y * int(viewport.x) + pixel.x;
}
