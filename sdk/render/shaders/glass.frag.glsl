// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A wall of glass: a tint, and what it mirrors at low angles.
#include "frame.glsl"
#include "ground.glsl"
#include "sky.glsl"
in vec3 world, world_normal;
flat in vec4 paint;
layout(location = 0) out vec4 color;

void main() {
  if (is_under_ground(world, 1e-5 * floor_.y)) discard;
  vec3 n = normalize(world_normal), to_eye = normalize(eye.xyz - world);
  float facing = abs(dot(n, to_eye));
  float mirrored = 0.04 + 0.5 * pow(1.0 - facing, 5.0);
  vec3 light = mix(paint.rgb * ambient_light(n), clear_sky(dot(reflect(-to_eye, n), up.xyz)), 0.5);
  color = vec4(light, clamp(0.06 + mirrored, 0.0, 0.5));
}
