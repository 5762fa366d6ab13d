// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A ball in the colour of its value, lit as other things are.
#include "frame.glsl"
#include "sky.glsl"
#include "shadow.glsl"
#include "material.glsl"
layout(binding = 6) uniform sampler2D colors;
layout(location = 0) uniform float radius;
flat in vec3 middle;
flat in float value;
layout(location = 0) out vec4 color;

void main() {
  vec3 ray = normalize(view_ray(gl_FragCoord.xy * viewport.zw));
  float along = dot(ray, middle);
  vec3 off = along * ray - middle;
  float inside = radius * radius - dot(off, off);
  if (inside < 0.0) discard;
  vec3 here = (along - sqrt(inside)) * ray;
  gl_FragDepth = to_window_depth(-here.z);
  vec3 n = mat3(camera_to_world) * ((here - middle) / radius);
  vec3 world = (camera_to_world * vec4(here, 1.0)).xyz;
  color = vec4(lit(texture(colors, vec2(value, 0.5)).rgb, 0.05, world, n), 1.0);
}
