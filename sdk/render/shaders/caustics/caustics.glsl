// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// The light that fluid gathers at a place, over what would come without waves.
#include "caustics/bundles.glsl"
layout(binding = 14) uniform usampler2D caustic_map;

float gathered_light(vec2 at) {
  vec2 place = at * vec2(textureSize(caustic_map, 0)) - 0.5, part = fract(place);
  ivec2 first = ivec2(floor(place)), last = textureSize(caustic_map, 0) - 1;
  float light = 0.0;
  // A tent of four texels: bundles are a texel wide.
  for (int k = 0; k < 16; ++k) {
    ivec2 apart = ivec2(k & 3, k >> 2) - 1;
    vec2 off = abs(vec2(apart) - part), weight = max(2.0 - off, 0.0) * 0.25;
    light += weight.x * weight.y * float(texelFetch(caustic_map, clamp(first + apart, ivec2(0), last), 0).r);
  }
  return light / whole_bundle;
}
