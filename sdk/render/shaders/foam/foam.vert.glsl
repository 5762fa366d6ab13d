// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A square around a piece of spray, foam or a bubble.
#include "shared/frame.glsl"
layout(location = 0) in vec3 centre_;
layout(location = 1) in float life;  // s
layout(location = 2) in uint kind;   // 0 spray, 1 foam, 2 bubble
layout(location = 0) uniform vec2 per_metre;  // clip space at distance 1
layout(location = 1) uniform float spacing;   // m

out vec2 offset;
flat out float distance_;  // along −z, m
flat out float opacity;

void main() {
  offset = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  vec4 clip = projection * view * vec4(centre_, 1.0);
  distance_ = clip.w;
  float radius = spacing * (kind == 0u ? 0.08 : kind == 1u ? 0.12 : 0.08);
  opacity = (kind == 0u ? 0.7 : kind == 1u ? 0.6 : 0.4) * smoothstep(0.0, 0.4, life);
  // One that is smaller than a pixel is as large, and as much fainter.
  float pixels = 0.5 * viewport.y * per_metre.y * radius / max(distance_, 1e-6);
  float grow = max(1.0, 0.9 / max(pixels, 1e-3));
  opacity /= grow * grow;
  gl_Position = clip.w > lens.z ? clip + vec4(offset * grow * radius * per_metre, 0.0, 0.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
