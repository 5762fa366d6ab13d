// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// One axis of the narrow-range filter (Truong & Yuksel 2018). Samples far behind do not count, nor do their
// counterparts on the other side; samples far in front count as if they were a little in front. The range
// grows with the samples that are in it, so that slopes are no edges. Averages are of 1/z, which is linear in
// the picture wherever the surface is a plane.
#include "frame.glsl"
#include "pixels.glsl"
#include "filter.glsl"

struct Range {
  float low, high;
};

// Whether the sample counts; what it counts as.
bool admit(inout float z, float here, inout Range range) {
  if (z <= 0.0 || z > here + range.high) return false;
  if (z < here - range.low) {
    z = here - 0.1 * floor_.z;
  } else {
    range.high = max(range.high, z - here + threshold);
    range.low = max(range.low, here - z + threshold);
  }
  return true;
}

// A drop in front of a surface leaves no dent in it.
float surface_at(ivec2 pixel, vec2 here) {
  ivec2 last = textureSize(fluid_depth, 0) - 1;
  vec2 there = texelFetch(fluid_depth, clamp(pixel, ivec2(0), last), 0).rg;
  return there.r > 0.0 && there.g < here.g - 0.4 ? here.r : there.r;
}

vec2 filtered(ivec2 pixel) {
  vec2 result = texelFetch(fluid_depth, pixel, 0).rg;
  float here = result.r;
  if (here <= 0.0) return result;
  int samples, stride;
  float falloff;
  choose_samples(pixel, here, result.g, samples, stride, falloff);
  float sum = 1.0 / here, weight = 1.0;
  Range range = Range(threshold, threshold);
  for (int k = 1; k <= samples; ++k) {
    float a = surface_at(pixel + k * stride * axis, result), b = surface_at(pixel - k * stride * axis, result);
    if (!admit(a, here, range) || !admit(b, here, range)) break;
    float w = exp(falloff * float(k * k));
    sum += w * (1.0 / a + 1.0 / b);
    weight += 2.0 * w;
  }
  result.r = weight / sum;
  return result;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (!is_outside(pixel)) imageStore(result_depth, pixel, vec4(filtered(pixel), 0.0, 0.0));
}
