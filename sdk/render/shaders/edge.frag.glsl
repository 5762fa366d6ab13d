// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A thin bar that is laid over the fluid, where it is before it: no shadow would be seen on it.
#include "frame.glsl"
#include "sky.glsl"
#include "ground.glsl"
in vec3 world, world_normal;
flat in vec4 paint;
layout(location = 0) out vec4 color;

void main() {
  if (is_under_ground(world, 0.0)) discard;
  vec3 n = normalize(world_normal);
  color = vec4(paint.rgb * (sun_light * max(dot(n, to_sun.xyz), 0.0) / 3.14159 * 2.0 + ambient_light(n)), 1.0);
}
