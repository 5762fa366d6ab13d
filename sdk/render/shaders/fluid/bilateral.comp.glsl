// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// One axis of a bilateral filter: samples count the less the further apart in depth they are.
#include "shared/frame.glsl"
#include "fluid/filter.glsl"

float filtered(ivec2 pixel, float found) {
  Row row = row_of(pixel);
  Samples samples = choose_samples(row, found);
  Weights w = weights_of(samples.weight);
  float here = abs(found), sum = here, weight = 1.0;
  for (int k = 1; k <= samples.count; ++k) {
    advance(w);
    vec2 z = abs(vec2(ahead(row, k * samples.stride), behind(row, k * samples.stride)));
    vec2 apart = (z - here) / threshold, share = w.at * exp(-0.5 * apart * apart);
    sum += dot(share, z);
    weight += share.x + share.y;
  }
  return sum / weight;
}
