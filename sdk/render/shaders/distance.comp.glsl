// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// How far away what stands in the scene is, or the ground. Clears what is drawn next: ROPs take far longer.
#include "frame.glsl"
#include "pixels.glsl"
#include "ground.glsl"
#include "mark.glsl"
layout(binding = 3) uniform sampler2D scene_depth;
layout(binding = 0, r32f) writeonly restrict uniform image2D scene_distance;  // along −z; marked where nothing stands
layout(binding = 1, rgba16f) writeonly restrict uniform image2D glass;
layout(binding = 2, rgba16f) writeonly restrict uniform image2D over;

float distance_at(ivec2 pixel) {
  float depth = texelFetch(scene_depth, pixel, 0).r, along;
  if (depth < 1.0) return marked(to_distance(depth), false);
  return marked(meets_ground(eye.xyz, world_ray(vec2(pixel)), along) ? along : 1e30, true);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (is_outside(pixel)) return;
  imageStore(scene_distance, pixel, vec4(distance_at(pixel)));
  imageStore(glass, pixel, vec4(0.0, 0.0, 0.0, 1.0));
  imageStore(over, pixel, vec4(0.0));
}
