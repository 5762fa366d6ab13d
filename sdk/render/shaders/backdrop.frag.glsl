// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Where the ground is; nothing stands there yet.
#include "frame.glsl"
#include "ground.glsl"
in vec2 place;
layout(location = 0) out vec4 albedo;
layout(location = 1) out vec4 normal;

void main() {
  float along;
  bool hit = meets_ground(eye.xyz, mat3(camera_to_world) * view_ray(place), along);
  gl_FragDepth = hit ? clamp(to_window_depth(along), 0.0, 1.0) : 1.0;
  albedo = normal = vec4(0.0);
}
