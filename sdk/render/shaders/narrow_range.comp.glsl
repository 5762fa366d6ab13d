// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// One axis of the narrow-range filter (Truong & Yuksel 2018). Samples far behind do not count, nor do their
// counterparts on the other side; samples far in front count as if they were a little in front. The range
// grows with the samples that are in it, so that slopes are no edges. Averages are of 1/z, which is linear in
// the picture wherever the surface is a plane.
#include "frame.glsl"
#include "filter.glsl"
#include "row.glsl"

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
float depth_beside(int pixels, vec2 here) {
  vec2 there = surface_beside(pixels);
  return there.r > 0.0 && there.g < here.g - 0.4 ? here.r : there.r;
}

vec2 filtered(vec2 here) {
  int samples, stride;
  float falloff, sum = 1.0 / here.r, weight = 1.0;
  choose_samples(here, samples, stride, falloff);
  Range range = Range(threshold, threshold);
  Weights w = weights_of(falloff);
  for (int k = 1; k <= samples; ++k) {
    float a = depth_beside(k * stride, here), b = depth_beside(-k * stride, here);
    if (!admit(a, here.r, range) || !admit(b, here.r, range)) break;
    advance(w);
    sum += w.at * (a + b) / (a * b);
    weight += 2.0 * w.at;
  }
  return vec2(weight / sum, here.g);
}

void main() {
  filter_row();
}
