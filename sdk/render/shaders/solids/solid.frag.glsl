// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
#include "shared/frame.glsl"
#include "light/ground.glsl"
#include "shared/surfaces.glsl"
in vec3 world, world_normal;
flat in vec4 paint;

void main() {
  vec3 n = normalize(world_normal);
  vec3 albedo = paint.rgb;
  // Cloth is seen from both sides, and is darker at the back. Which side it is says the triangle: at an outline the
  // smooth normal may point away from the eye on the front, too.
  vec3 flat_normal = cross(dFdx(world), dFdy(world));
  if (dot(n, flat_normal) * dot(flat_normal, eye.xyz - world) < 0.0) {
    n = -n;
    if (paint.a > 0.5) albedo *= 0.6;
  }
  if (is_under_ground(world, 1e-5 * floor_.y)) discard;
  put(albedo, paint.a < 0.5 ? 0.35 : 0.05, n);
}
