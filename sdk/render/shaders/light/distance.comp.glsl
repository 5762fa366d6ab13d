// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// How far away what stands in the scene is, and what it is: solids, the floors of vessels, or the ground.
#include "shared/frame.glsl"
#include "shared/pixels.glsl"
#include "light/ground.glsl"
#include "light/scene.glsl"
#include "light/vessels.glsl"
layout(binding = 3) uniform sampler2D scene_depth;
layout(binding = 0, rg32f) writeonly restrict uniform image2D scene_distance;  // along −z; what it is
layout(location = 0) uniform int has_solids;

struct Found {
  float distance;
  int what;
};

// Of the faces by which the ray comes in and goes out the first that is a floor and nearer than what was found.
void find_floor(uint vessel, vec3 direction, inout Found found) {
  Passage p;
  if (!passes(vessel, direction, p)) return;
  for (int k = 0; k < 2; ++k) {
    float along = k == 0 ? p.enter : p.leave;
    int face = k == 0 ? p.enter_face : p.leave_face;
    if (along < lens.z || along >= found.distance) continue;
    if (!is_part(vessel, vessels[vessel].parts.y, face, p.from + along * p.direction)) continue;
    if (is_under_ground(eye.xyz + along * direction, 1e-5 * floor_.y)) continue;
    found = Found(along, is_floor + 6 * int(vessel) + face);
  }
}

Found find_at(ivec2 pixel) {
  vec3 direction = world_ray(vec2(pixel));
  Found found = Found(1e30, is_nothing);
  float along;
  if (meets_ground(eye.xyz, direction, along)) found = Found(along, is_ground);
  float depth = has_solids == 1 ? texelFetch(scene_depth, pixel, 0).r : 1.0;
  if (depth < 1.0) found = Found(to_distance(depth), is_solid);
  for (uint k = 0u; k < vessel_count.x; ++k) find_floor(k, direction, found);
  return found;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (is_outside(pixel)) return;
  Found found = find_at(pixel);
  imageStore(scene_distance, pixel, vec4(found.distance, float(found.what), 0.0, 0.0));
}
