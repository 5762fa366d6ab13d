// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A square that faces the sun, through the centre of a grain.
#include "shared/frame.glsl"
#include "particles/fluids.glsl"
layout(location = 0) in vec3 centre_;
layout(location = 1) in vec3 radii;
layout(location = 3) in uint fluid;
out vec2 offset;

void main() {
  offset = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  vec4 clip = world_to_sun * vec4(centre_, 1.0);
  clip.xy += offset * radii.x / to_sun.w;
  gl_Position = is_grain(fluid) ? clip : nowhere;
}
