// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A line, widened to so many pixels, a little in front of the surface that it stands on.
#include "shared/frame.glsl"
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec3 color;
layout(location = 0) uniform float pixels;

flat out vec3 paint;

void main() {
  paint = color;
  vec4 a = projection * view * vec4(from, 1.0), b = projection * view * vec4(to, 1.0);
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport.xy;
  along = dot(along, along) > 1e-8 ? normalize(along) : vec2(1.0, 0.0);
  vec4 at = (gl_VertexID & 2) == 0 ? a : b;
  vec2 aside = (gl_VertexID & 1) == 0 ? vec2(-along.y, along.x) : vec2(along.y, -along.x);
  at.xy += aside * pixels * viewport.zw * at.w;
  at.z -= 2e-4 * at.w;
  bool is_ahead = min(a.w, b.w) > lens.z;
  gl_Position = is_ahead ? at : vec4(0.0, 0.0, 2.0, 1.0);
}
