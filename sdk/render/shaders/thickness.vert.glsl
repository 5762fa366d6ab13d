// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A square around a particle, for the sums over what lies along each line of sight.
#include "frame.glsl"
#include "fluids.glsl"
layout(location = 0) in vec3 centre_;
layout(location = 3) in uint fluid;
layout(location = 0) uniform mat4 to_clip;   // of the world
layout(location = 1) uniform vec2 per_metre;  // clip space at distance 1
layout(location = 2) uniform float radius;   // m, of the square

out vec2 offset;
flat out float distance_;  // w of clip space
flat out vec3 absorbance;  // along a metre
flat out float window_depth;

void main() {
  offset = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  vec4 clip = to_clip * vec4(centre_, 1.0);
  distance_ = clip.w;
  // On the path that the colour is given for the colour is left of the light; what is all black would take in all
  // at once.
  absorbance = -log(clamp(look_of(fluid).rgb, 0.02, 0.98)) / centre.w;
  window_depth = 0.5 * clip.z / clip.w + 0.5;
  gl_Position = is_grain(fluid) ? nowhere : clip + vec4(offset * radius * per_metre, 0.0, 0.0);
}
