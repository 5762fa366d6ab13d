// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Its tiles, which fade into the sky.
#include "light/tiling.glsl"

// `wide`: of a pixel, in tiles; `open`: see light/material.glsl.
vec3 ground_color(vec3 world, vec3 direction, vec2 wide, float open) {
  vec3 color = lit(tiles(tile_place(ground.xyz, world), wide, vec3(0.18, 0.185, 0.19)), 0.02, 0.0, open, world, ground.xyz);
  float away = max(length(world - centre.xyz) / floor_.w - 1.2, 0.0);
  vec3 level = normalize(direction - dot(direction, up.xyz) * up.xyz);
  return mix(sky(level), color, exp(-0.16 * away * away));
}
