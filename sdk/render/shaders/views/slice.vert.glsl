// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
#include "shared/frame.glsl"
layout(location = 0) uniform vec3 corner;
layout(location = 1) uniform vec3 across;
layout(location = 2) uniform vec3 upwards;

out vec2 place;

void main() {
  place = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = projection * view * vec4(corner + place.x * across + place.y * upwards, 1.0);
}
