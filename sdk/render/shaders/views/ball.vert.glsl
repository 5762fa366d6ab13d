// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A square across the line of sight, which covers the picture of a ball.
#include "shared/frame.glsl"
layout(location = 0) in vec4 ball;  // w: place in the colours
layout(location = 0) uniform float radius;

flat out vec3 middle;  // view space
flat out float value;

void main() {
  middle = (view * vec4(ball.xyz, 1.0)).xyz;
  value = ball.w;
  float away2 = dot(middle, middle);
  vec3 ahead = normalize(middle);
  vec3 right = normalize(cross(ahead, abs(ahead.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  // The cone of sight that touches the ball is so wide where it passes the middle.
  float size = radius * sqrt(away2 / max(away2 - radius * radius, 1e-12));
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? -size : size, (gl_VertexID & 2) == 0 ? -size : size);
  gl_Position = projection * vec4(middle + corner.x * right + corner.y * cross(right, ahead), 1.0);
  // One that the eye is in, or nearly, would hide all.
  if (-middle.z < lens.z + radius) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}
