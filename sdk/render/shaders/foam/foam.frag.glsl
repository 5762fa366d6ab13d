// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// What one piece adds: red before the fluid's surface, or on it; green behind it, and blue that times how far
// behind, m.
#include "shared/frame.glsl"
#include "fluid/fluid_depth.glsl"
layout(binding = 3) uniform sampler2D scene_distance;
layout(location = 1) uniform float spacing;
in vec2 offset;
flat in float distance_, opacity;
layout(location = 0) out vec4 sums;

void main() {
  float u = 1.0 - dot(offset, offset);
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (u <= 0.0 || distance_ > texelFetch(scene_distance, pixel, 0).r) discard;
  float surface = fluid_depth(pixel);
  float behind = surface > 0.0 ? max(distance_ - surface - 0.5 * spacing, 0.0) : 0.0;
  float amount = opacity * u;
  sums = behind > 0.0 ? vec4(0.0, amount, amount * behind, 0.0) : vec4(amount, 0.0, 0.0, 0.0);
}
