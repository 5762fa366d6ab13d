// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A rectangle around the picture of a grain, no two of which are quite alike.
#include "shared/frame.glsl"
#include "particles/fluids.glsl"
#include "particles/quadric.glsl"
#include "shared/random.glsl"
layout(location = 0) in vec3 centre_;
layout(location = 1) in vec3 radii;
layout(location = 3) in uint fluid;

flat out vec3 middle, albedo;  // in view space; linear RGB
flat out float radius;
noperspective out vec3 ray;  // from the eye, per unit of distance along −z

void main() {
  middle = (view * vec4(centre_, 1.0)).xyz;
  radius = radii.x;
  vec2 low, high;
  picture_of(mat4(vec4(radius, 0.0, 0.0, 0.0), vec4(0.0, radius, 0.0, 0.0), vec4(0.0, 0.0, radius, 0.0),
                  vec4(middle, 1.0)), low, high);
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? low.x : high.x, (gl_VertexID & 2) == 0 ? low.y : high.y);
  ray = vec3(corner * lens.xy, -1.0);
  float shade = random(ivec2(gl_InstanceID, 0)), tint = random(ivec2(gl_InstanceID, 1)) - 0.5;
  albedo = look_of(fluid).rgb * mix(0.6, 1.3, shade) * (1.0 + 0.3 * tint * vec3(1.0, 0.0, -1.0));
  gl_Position = is_grain(fluid) && is_seen(middle, radius) ? vec4(corner, 0.0, 1.0) : nowhere;
}
