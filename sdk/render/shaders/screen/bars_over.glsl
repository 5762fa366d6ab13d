// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Lays the edges of vessels over the picture where nothing hides them.
#include "light/sky.glsl"
#include "screen/bars.glsl"
#include "fluid/fluid_depth.glsl"
layout(binding = 2) uniform sampler2D scene_color;
layout(binding = 3) uniform sampler2D scene_distance;

// Without shadows: none would be seen on so thin a bar.
vec3 bar_color(vec3 n) {
  return vec3(0.62, 0.70, 0.74) * (sun_light * max(dot(n, to_sun.xyz), 0.0) / 3.14159 * 2.0 + ambient_light(n));
}

// All threads of a group take part.
vec3 color_with_bars(ivec2 pixel) {
  float fluid = fluid_depth(pixel), behind = texelFetch(scene_distance, pixel, 0).r;
  vec3 color = texelFetch(scene_color, pixel, 0).rgb;
  BarHit hit = find_bar(vec2(pixel), fluid > 0.0 ? min(fluid, behind) : behind);
  return hit.bar != ~0u ? bar_color(hit.normal) : color;
}
