// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// From light to sRGB, by a curve like that of film (Narkowicz's fit to ACES); luma beside it. What is drawn over the
// picture is laid over it where the fluid does not hide it.
#include "frame.glsl"
#include "pixels.glsl"
layout(binding = 2) uniform sampler2D scene_color;
layout(binding = 4) uniform sampler2D fluid_depth;
layout(binding = 6) uniform sampler2D over;  // times its opacity
layout(binding = 8) uniform sampler2D scene_depth;  // with that
layout(binding = 0, rgba8) writeonly restrict uniform image2D toned;

vec3 color_at(ivec2 pixel) {
  vec3 color = texelFetch(scene_color, pixel, 0).rgb;
  vec4 before = texelFetch(over, pixel, 0);
  if (before.a == 0.0) return color;
  float z = texelFetch(fluid_depth, pixel, 0).r;
  bool is_hidden = z > 0.0 && to_window_depth(z) <= texelFetch(scene_depth, pixel, 0).r;
  return is_hidden ? color : before.rgb + (1.0 - before.a) * color;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (is_outside(pixel)) return;
  vec3 c = 0.80 * color_at(pixel);
  c = clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
  c = mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
  imageStore(toned, pixel, vec4(c, dot(c, vec3(0.299, 0.587, 0.114))));
}
