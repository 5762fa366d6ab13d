// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// One axis of a bilateral filter: samples count the less the further apart in depth they are.
#include "frame.glsl"
#include "pixels.glsl"
#include "filter.glsl"

vec2 filtered(ivec2 pixel) {
  vec2 result = texelFetch(fluid_depth, pixel, 0).rg;
  float here = result.r;
  if (here <= 0.0) return result;
  int samples, stride;
  float falloff;
  choose_samples(pixel, here, result.g, samples, stride, falloff);
  float sum = here, weight = 1.0;
  for (int k = 1; k <= samples; ++k) {
    for (int side = -1; side <= 1; side += 2) {
      float z = depth_at(pixel + side * k * stride * axis);
      if (z <= 0.0) continue;
      float apart = (z - here) / threshold;
      float w = exp(falloff * float(k * k) - 0.5 * apart * apart);
      sum += w * z;
      weight += w;
    }
  }
  result.r = sum / weight;
  return result;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (!is_outside(pixel)) imageStore(result_depth, pixel, vec4(filtered(pixel), 0.0, 0.0));
}
