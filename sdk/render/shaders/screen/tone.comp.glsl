// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// From light to sRGB, by a curve like that of film (Narkowicz's fit to ACES); luma beside it. The edges of vessels are
// laid over the picture where nothing hides them.
#include "shared/frame.glsl"
#include "shared/pixels.glsl"
#include "light/sky.glsl"
#include "screen/bars.glsl"
#include "fluid/fluid_depth.glsl"
layout(binding = 2) uniform sampler2D scene_color;
layout(binding = 3) uniform sampler2D scene_distance;
layout(binding = 0, rgba8) writeonly restrict uniform image2D toned;

// Without shadows: none would be seen on so thin a bar.
vec3 bar_color(vec3 n) {
  return vec3(0.62, 0.70, 0.74) * (sun_light * max(dot(n, to_sun.xyz), 0.0) / 3.14159 * 2.0 + ambient_light(n));
}

vec3 color_at(ivec2 pixel) {
  float fluid = fluid_depth(pixel), behind = texelFetch(scene_distance, pixel, 0).r;
  vec3 color = texelFetch(scene_color, pixel, 0).rgb;
  BarHit hit = find_bar(vec2(pixel), fluid > 0.0 ? min(fluid, behind) : behind);
  return hit.bar != ~0u ? bar_color(hit.normal) : color;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  vec3 c = 0.80 * color_at(min(pixel, ivec2(viewport.xy) - 1));
  if (is_outside(pixel)) return;
  c = clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
  c = mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
  imageStore(toned, pixel, vec4(c, dot(c, vec3(0.299, 0.587, 0.114))));
}
