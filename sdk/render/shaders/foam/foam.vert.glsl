// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A square around a piece of spray, foam or a bubble. Its opacity is spread over a wider kernel, of which foam is the
// sum. Spray is stretched along its motion.
#include "shared/frame.glsl"
#include "shared/exposure.glsl"
layout(location = 0) in vec3 centre_;
layout(location = 1) in float life;  // s
layout(location = 2) in uint kind;   // 0 spray, 1 foam, 2 bubble
layout(location = 3) in vec3 velocity;
layout(location = 0) uniform vec2 per_metre;  // clip space at distance 1
layout(location = 1) uniform vec2 texels;     // of the sums

out vec2 offset;
flat out float distance_;  // along −z, m
flat out float opacity;

// Of a kind: the spacings that a piece is wide, those over which it is spread, and how much it hides in its middle.
const float radii[3] = float[](0.08, 0.12, 0.08), kernels[3] = float[](0.22, 0.45, 0.45);
const float opacities[3] = float[](0.40, 0.345, 0.22);

void main() {
  offset = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  vec4 clip = projection * view * vec4(centre_, 1.0);
  distance_ = clip.w;
  uint k = min(kind, 2u);
  // No smaller than a texel: fainter instead.
  float texel = 2.0 / texels.y * max(distance_, 1e-6) / per_metre.y, radius = max(kernels[k] * floor_.z, 0.9 * texel);
  float share = radii[k] * floor_.z / radius;
  opacity = opacities[k] * share * share * smoothstep(0.0, 0.4, life);
  vec2 along = vec2(0.0);
  if (kind == 0u) along = exposure * (mat3(view) * velocity).xy;
  float way = length(along), stretch = 1.0 + way / radius;
  vec2 ahead = way > 0.0 ? along / way : vec2(1.0, 0.0);
  vec2 reach = radius * (offset.x * stretch * ahead + offset.y * vec2(-ahead.y, ahead.x));
  opacity /= stretch;
  gl_Position = clip.w > lens.z ? clip + vec4(reach * per_metre, 0.0, 0.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
