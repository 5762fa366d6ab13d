// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// What one piece adds to the front layer, or to the rest: red before the layer's surface, or on it; green behind it,
// and blue that times how much fluid lies before it, m.
#include "shared/frame.glsl"
#include "fluid/fluid_depth.glsl"
#include "fluid/rest_depth.glsl"
#include "fluid/front_and_rest.glsl"
layout(binding = 3) uniform sampler2D scene_distance;
in vec2 offset;
flat in float distance_, opacity;
layout(location = 0) out vec4 front_sums;
layout(location = 1) out vec4 rest_sums;

// Behind a surface by so much it is foam in the fluid, and by a spacing less it is on it. Between, it is both.
vec4 sums_of(float amount, float surface, float metres) {
  if (surface <= 0.0) return vec4(amount, 0.0, 0.0, 0.0);
  float behind = max(distance_ - surface - 0.5 * floor_.z, 0.0), inside = min(behind / floor_.z, 1.0);
  return amount * vec4(1.0 - inside, inside, inside * min(behind, metres), 0.0);
}

void main() {
  float u = 1.0 - dot(offset, offset);
  ivec2 texel = ivec2(gl_FragCoord.xy), pixel = 2 * texel;
  if (u <= 0.0 || distance_ > texelFetch(scene_distance, pixel, 0).r) discard;
  float first = fluid_depth(pixel), rest = rest_depth(pixel);
  bool is_rest = rest > 0.0 && distance_ > front_end(texel);
  float metres = is_rest ? texelFetch(rest_layer, texel, 0).a : texelFetch(front_layer, texel, 0).a;
  vec4 sums = sums_of(opacity * u, is_rest ? rest : first, metres);
  front_sums = is_rest ? vec4(0.0) : sums;
  rest_sums = is_rest ? sums : vec4(0.0);
}
