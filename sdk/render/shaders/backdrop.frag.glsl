// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Sky, and a ground that fades into it.
#include "frame.glsl"
#include "sky.glsl"
#include "shadow.glsl"
#include "material.glsl"
#include "ground.glsl"

in vec2 place;
layout(location = 0) out vec4 color;

void main() {
  vec3 ray = view_ray(place);
  vec3 direction = mat3(camera_to_world) * ray;
  float along;
  bool hit = meets_ground(eye.xyz, direction, along);
  color = vec4(hit ? ground_color(eye.xyz + along * direction, normalize(direction)) : sky(normalize(direction)), 1.0);
  gl_FragDepth = hit ? clamp(to_window_depth(along), 0.0, 1.0) : 1.0;
}
