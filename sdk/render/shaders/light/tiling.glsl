// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Two tones, with seams: lines of one width in the picture would flicker, so they fade with distance. `wide`: how far
// a pixel reaches.
vec3 tiles(vec2 at, vec2 wide, vec3 tone) {
  vec2 cell = floor(at), inside = abs(fract(at) - 0.5);
  float blur = clamp(max(wide.x, wide.y) * 1.5, 0.0, 1.0);
  float even = mod(cell.x + cell.y, 2.0);
  vec2 seam = smoothstep(0.5 - 0.018 - wide, vec2(0.5 - 0.010), inside);
  float line = max(seam.x, seam.y) * (1.0 - blur);
  return tone * mix(mix(0.86, 1.0, even), 0.93, blur) * (1.0 - 0.30 * line);
}

// Along a plane, in tiles.
vec2 tile_place(vec3 normal, vec3 world) {
  vec3 a = abs(normal.x) < 0.7 ? vec3(1.0, 0.0, 0.0) - normal.x * normal : vec3(0.0, 0.0, 1.0) - normal.z * normal;
  a = normalize(a);
  return vec2(dot(a, world), dot(cross(normal, a), world)) / floor_.x;
}
