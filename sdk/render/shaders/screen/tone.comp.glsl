// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// The edges of vessels over the picture, and the tone curve.
#include "shared/frame.glsl"
#include "shared/pixels.glsl"
#include "screen/bars_over.glsl"
#include "screen/film.glsl"
layout(binding = 0, rgba8) writeonly restrict uniform image2D toned;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  vec3 light = color_with_bars(min(pixel, ivec2(viewport.xy) - 1));
  if (!is_outside(pixel)) imageStore(toned, pixel, developed(light));
}
