// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
#include "shared/frame.glsl"
#include "light/ground.glsl"
#include "shared/surfaces.glsl"
#include "solids/strands.glsl"
#include "solids/weave.glsl"
in vec3 world, world_normal;
in vec2 place;
flat in vec4 paint;

void main() {
  vec3 n = normalize(world_normal), along_x = dFdx(world), along_y = dFdy(world);
  vec3 albedo = paint.rgb;
  bool is_cloth = paint.a > 0.5 && paint.a < 1.5, is_rope = paint.a > 1.5;
  // Cloth is seen from both sides, and is darker at the back. Which side it is says the triangle: at an outline the
  // smooth normal may point away from the eye on the front, too.
  vec3 flat_normal = cross(along_x, along_y);
  if (dot(n, flat_normal) * dot(flat_normal, eye.xyz - world) < 0.0) {
    n = -n;
    if (is_cloth) albedo *= 0.6;
  }
  if (is_cloth) weave(place, dFdx(place), dFdy(place), along_x, along_y, n, albedo);
  if (is_rope) twist(place, dFdx(place), dFdy(place), along_x, along_y, n, albedo);
  if (is_under_ground(world, 1e-5 * floor_.y)) discard;
  put(albedo, paint.a < 0.5 ? 0.35 : 0.05, n, is_cloth ? 1.0 : is_rope ? 0.5 : 0.0);
}
