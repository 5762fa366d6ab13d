// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
#include "shared/frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;  // a: 0 glossy, 1 cloth, 2 rope
layout(location = 3) in vec2 place_;
layout(location = 0) uniform mat4 model;

out vec3 world, world_normal;
out vec2 place;  // of ropes: the angle around the line, and the way along it in radii; of cloth: threads along u, v
flat out vec4 paint;

void main() {
  world = (model * vec4(position, 1.0)).xyz;
  world_normal = mat3(model) * normal;
  paint = color;
  place = place_;
  gl_Position = projection * view * vec4(world, 1.0);
}
