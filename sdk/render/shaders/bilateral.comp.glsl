// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// One axis of a bilateral filter: samples count the less the further apart in depth they are.
#include "frame.glsl"
#include "filter.glsl"
#include "row.glsl"

vec2 filtered(vec2 here) {
  int samples, stride;
  float falloff, sum = here.r, weight = 1.0;
  choose_samples(here, samples, stride, falloff);
  Weights along = weights_of(falloff);
  for (int k = 1; k <= samples; ++k) {
    advance(along);
    for (int side = -1; side <= 1; side += 2) {
      float z = surface_beside(side * k * stride).r;
      if (z <= 0.0) continue;
      float apart = (z - here.r) / threshold;
      float w = along.at * exp(-0.5 * apart * apart);
      sum += w * z;
      weight += w;
    }
  }
  return vec2(sum / weight, here.g);
}

void main() {
  filter_row();
}
