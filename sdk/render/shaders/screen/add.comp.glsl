// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Adds a picture, with the edges of vessels, to others; the tone curve is for their mean.
#include "shared/frame.glsl"
#include "shared/pixels.glsl"
#include "screen/bars_over.glsl"
#include "screen/film.glsl"
layout(binding = 0, rgba8) writeonly restrict uniform image2D toned;
layout(binding = 1, rgba32f) restrict uniform image2D sums;
layout(location = 0) uniform int sample_;
layout(location = 1) uniform float share;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  vec3 light = share * color_with_bars(min(pixel, ivec2(viewport.xy) - 1));
  if (is_outside(pixel)) return;
  if (sample_ > 0) light += imageLoad(sums, pixel).rgb;
  imageStore(sums, pixel, vec4(light, 1.0));
  imageStore(toned, pixel, developed(light));
}
