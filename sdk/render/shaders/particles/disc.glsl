// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// The pixels around a disc that faces the viewer, from first to last; first > last where there are none. `reach`: its
// radius in clip space.
ivec4 disc_pixels(vec4 clip, vec2 reach, ivec2 size) {
  if (!(abs(clip.z) < clip.w)) return ivec4(0, 0, -1, -1);
  vec2 middle = (0.5 * clip.xy / clip.w + 0.5) * vec2(size) - 0.5, half_size = 0.5 * reach / clip.w * vec2(size);
  vec2 last = vec2(size - 1);
  return ivec4(ceil(clamp(middle - half_size, vec2(0.0), last + 1.0)), floor(clamp(middle + half_size, vec2(-1.0), last)));
}
