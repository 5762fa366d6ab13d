// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// What the filters of the fluid's depth share. Depths are distances along −z; 0 is where there is no fluid. Beside
// them stands how far the filter reaches, as a share.
layout(binding = 4) uniform sampler2D fluid_depth;
layout(binding = 0, rg32f) writeonly restrict uniform image2D result_depth;
layout(location = 0) uniform ivec2 axis;     // pixels, from one sample to the next
layout(location = 1) uniform float reach;    // m, one standard deviation
layout(location = 2) uniform float threshold;  // m: what is further apart in depth is another surface

const int most_samples = 24;  // to each side

float depth_at(ivec2 pixel) {
  ivec2 last = textureSize(fluid_depth, 0) - 1;
  return texelFetch(fluid_depth, clamp(pixel, ivec2(0), last), 0).r;
}

// How much shorter a way along the surface looks where it leads away from the eye, from the depths so many
// pixels to each side: a filter is to reach equally far along it in all directions.
float foreshortening(ivec2 pixel, float distance, int apart, float pixels_per_metre) {
  float a = depth_at(pixel + apart * axis), b = depth_at(pixel - apart * axis);
  if (min(a, b) <= 0.0 || max(abs(a - distance), abs(b - distance)) > threshold) return 1.0;
  float slope = (a - b) * pixels_per_metre / float(2 * apart);
  return max(inversesqrt(1.0 + slope * slope), 0.3);
}

// Pixels to each side, and from one sample to the next: two standard deviations, at this distance.
void choose_samples(ivec2 pixel, float distance, float share, out int samples, out int stride, out float falloff) {
  float pixels_per_metre = viewport.y / (2.0 * lens.y * distance), pixels = share * reach * pixels_per_metre;
  pixels *= foreshortening(pixel, distance, max(int(pixels), 1), pixels_per_metre);
  int radius = int(ceil(2.0 * pixels));
  stride = max((radius + most_samples - 1) / most_samples, 1);
  samples = radius / stride;
  falloff = -0.5 * float(stride * stride) / (pixels * pixels);
}
