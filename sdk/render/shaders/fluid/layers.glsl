// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Where fluid lies along a line of sight: one bit per slice of depth, from the first surface on. Slices grow with
// depth, so that 32 of them reach through any scene. The first run of bits is the front layer; the rest lies behind a gap.
// There are eight to an octave of 1 + depth / scale, as in a float's bits below 2⁴.
const int slice_shift = 20;  // to three bits of the mantissa
const uint first_slice = 0x3f800000u;  // the bits of 1

// m; the first slice has three quarters of a spacing.
float slice_scale() {
  return 6.0 * floor_.z;
}
uvec4 slice_at(vec4 beyond) {
  return min((floatBitsToUint(1.0 + max(beyond, 0.0) / slice_scale()) - first_slice) >> slice_shift, 31u);
}
float slice_begin(int slice) {
  return slice_scale() * (uintBitsToFloat(first_slice + (uint(slice) << slice_shift)) - 1.0);
}

// Light that a layer's depths send back, 0 to 1, as a square root of ten bits a colour.
uint packed_glow(vec3 glow) {
  uvec3 bits = uvec3(1023.0 * sqrt(clamp(glow, 0.0, 1.0)) + 0.5);
  return bits.x | bits.y << 10 | bits.z << 20;
}
vec3 unpacked_glow(uint bits) {
  vec3 root = vec3(uvec3(bits) >> uvec3(0, 10, 20) & 1023u) / 1023.0;
  return root * root;
}

// All bits from `first` to `last`.
uvec4 slices_between(uvec4 first, uvec4 last) {
  return (~uvec4(0u) << first) & (~uvec4(0u) >> (31u - last));
}

// How far behind the first surface, m, the gap after the front layer begins and ends; no_gap if nothing follows.
const float no_gap = 1e30;
vec2 gap_behind(uint slices) {
  if (slices == 0u) return vec2(no_gap);
  uint front = slices >> findLSB(slices);
  int end = findLSB(slices) + findLSB(~front);
  if (~front == 0u || end > 31 || slices >> end == 0u) return vec2(no_gap);
  return vec2(slice_begin(end), slice_begin(end + findLSB(slices >> end)));
}
