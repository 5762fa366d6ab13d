// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// One axis of the narrow-range filter (Truong & Yuksel 2018). Samples far behind do not count, nor do their
// counterparts on the other side; samples far in front count as if they were a little in front. The range
// grows with the samples that are in it, so that slopes are no edges. Averages are of 1/z, which is linear in
// the picture wherever the surface is a plane.
#include "shared/frame.glsl"
#include "fluid/filter.glsl"

// A drop in front of a surface leaves no dent in it. `least`: 0, or less than all where the pixel itself shows a drop.
float level(float found, float here, float least) {
  return found < least ? here : abs(found);
}

struct Range {
  float near, far;
};

void widen(inout Range range, float low, float high) {
  range.near = min(range.near, low - threshold);
  range.far = max(range.far, high + threshold);
}

// Whether the sample counts; what it counts as.
bool admit(inout float z, float here, inout Range range) {
  if (z > range.far) return false;
  if (z < range.near)
    z = here - 0.1 * floor_.z;
  else
    widen(range, z, z);
  return true;
}

// One after the other; nearly always both are in the range, and it is all the same.
bool admit_both(inout float a, inout float b, float here, inout Range range) {
  float low = min(a, b), high = max(a, b);
  if (low < range.near || high > range.far) return admit(a, here, range) && admit(b, here, range);
  widen(range, low, high);
  return true;
}

float filtered(ivec2 pixel, float found) {
  Row row = row_of(pixel);
  Samples samples = choose_samples(row, found);
  Weights w = weights_of(samples.weight);
  float here = abs(found), least = found < 0.0 ? -1e38 : 0.0, sum = 1.0 / here, weight = 1.0;
  Range range = Range(here - threshold, here + threshold);
  for (int k = 1, places = samples.stride; k <= samples.count; ++k, places += samples.stride) {
    float a = level(ahead(row, places), here, least), b = level(behind(row, places), here, least);
    if (!admit_both(a, b, here, range)) break;
    advance(w);
    sum += w.at * (a + b) / (a * b);
    weight += 2.0 * w.at;
  }
  return weight / sum;
}
