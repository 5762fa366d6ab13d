// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Where fluid lies along a line of sight: one bit per slice of depth, from the first surface on. Slices grow with
// depth, so that 32 of them reach through any scene. The first run of bits is the front layer; the rest lies behind a gap.
const float slice_growth = 1.1;

// m; the first slice has three quarters of a spacing.
float slice_scale() {
  return 0.75 * floor_.z / (slice_growth - 1.0);
}
vec4 slice_at(vec4 beyond) {
  return clamp(floor(log2(1.0 + max(beyond, 0.0) / slice_scale()) / log2(slice_growth)), 0.0, 31.0);
}
float slice_begin(int slice) {
  return slice_scale() * (pow(slice_growth, float(slice)) - 1.0);
}

// All bits from `first` to `last`.
uvec4 slices_between(vec4 first, vec4 last) {
  return (~uvec4(0u) << uvec4(first)) & (~uvec4(0u) >> (31u - uvec4(last)));
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
