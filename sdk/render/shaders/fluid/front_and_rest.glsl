// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// How much fluid the front layer and the rest hold, at half of the picture's pixels each way.
#include "fluid/layers.glsl"
layout(binding = 5) uniform sampler2D front_layer;  // absorbance; metres
layout(binding = 9) uniform sampler2D rest_layer;   // likewise
layout(binding = 10) uniform usampler2D layer_slices;  // bits of the first surface's distance; slices; both glows

// Distance along −z at which the front layer ends for sure, and the rest has not begun.
float front_end(ivec2 texel) {
  uvec4 slices = texelFetch(layer_slices, texel, 0);
  vec2 gap = gap_behind(slices.y);
  return gap.x < no_gap ? uintBitsToFloat(slices.x) + 0.5 * (gap.x + gap.y) : no_gap;
}

ivec2 texel_of(ivec2 pixel) {
  return min(pixel / 2, textureSize(layer_slices, 0) - 1);
}

// Absorbance and metres of the layer whose surface is at the distance z, and the light that its depths send back. A texel gives its rest to the rest, and
// where its front layer ends before z. One whose first surface is further away tells nothing of what is at z.
vec4 layer_at(ivec2 pixel, float z, bool is_rest, out vec3 glow) {
  vec2 at = 0.5 * vec2(pixel) - 0.25, part = fract(at);
  ivec2 first = ivec2(floor(at)), last = textureSize(layer_slices, 0) - 1;
  vec4 sums = vec4(0.0);
  vec3 glows = vec3(0.0);
  float weights = 0.0;
  for (int k = 0; k < 4; ++k) {
    ivec2 texel = clamp(first + ivec2(k & 1, k >> 1), ivec2(0), last);
    uvec4 slices = texelFetch(layer_slices, texel, 0);
    float nearest = uintBitsToFloat(slices.x), end = front_end(texel);
    if (nearest < no_gap && nearest > z + 3.0 * floor_.z) continue;
    float weight = ((k & 1) == 1 ? part.x : 1.0 - part.x) * (k > 1 ? part.y : 1.0 - part.y) + 1e-4;
    bool has_rest = end < no_gap && (is_rest || z > end);
    vec4 here = weight * (has_rest ? texelFetch(rest_layer, texel, 0) : texelFetch(front_layer, texel, 0));
    sums += here;
    glows += here.a * unpacked_glow(has_rest ? slices.w : slices.z);
    weights += weight;
  }
  glow = glows / max(sums.a, 1e-9);
  return weights > 0.0 ? sums / weights : vec4(0.0);
}
