// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A ball in the colour of its value, lit as other things are.
#include "shared/frame.glsl"
#include "light/ground.glsl"
#include "shared/surfaces.glsl"
layout(binding = 6) uniform sampler2D colors;
layout(location = 0) uniform float radius;
flat in vec3 middle;
flat in float value;

void main() {
  vec3 ray = normalize(view_ray(gl_FragCoord.xy * viewport.zw));
  float along = dot(ray, middle);
  vec3 off = along * ray - middle;
  float inside = radius * radius - dot(off, off);
  if (inside < 0.0) discard;
  vec3 here = (along - sqrt(inside)) * ray;
  if (is_under_ground((camera_to_world * vec4(here, 1.0)).xyz, 0.0)) discard;
  gl_FragDepth = to_window_depth(-here.z);
  put(texture(colors, vec2(value, 0.5)).rgb, 0.05, mat3(camera_to_world) * ((here - middle) / radius), 0.0);
}
