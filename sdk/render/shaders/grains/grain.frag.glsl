// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
#include "shared/frame.glsl"
#include "light/ground.glsl"
#include "shared/surfaces.glsl"
flat in vec3 middle, albedo;
flat in float radius;
noperspective in vec3 ray;

void main() {
  // From the point nearest to the centre, as for ellipsoids.
  float square = dot(ray, ray), near = dot(middle, ray) / square;
  vec3 off = near * ray - middle;
  float inside = radius * radius - dot(off, off);
  if (inside < 0.0) discard;
  float distance = near - sqrt(inside / square);
  vec3 here = distance * ray;
  if (is_under_ground((camera_to_world * vec4(here, 1.0)).xyz, 0.0)) discard;
  gl_FragDepth = to_window_depth(distance);
  put(albedo, 0.02, mat3(camera_to_world) * ((here - middle) / radius), 0.0);
}
