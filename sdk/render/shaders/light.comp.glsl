// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Light on what is there: what stands in the scene, the ground, which fades into the sky, and that.
#include "frame.glsl"
#include "pixels.glsl"
#include "sky.glsl"
#include "shadow.glsl"
#include "material.glsl"
#include "ground.glsl"
#include "ground_color.glsl"
layout(binding = 2) uniform sampler2D albedos;  // a: gloss
layout(binding = 3) uniform sampler2D scene_depth;
layout(binding = 8) uniform sampler2D normals;
layout(binding = 0, rgba16f) writeonly restrict uniform image2D scene_color;
layout(binding = 1, r32f) writeonly restrict uniform image2D scene_distance;  // along −z, m

vec3 direction_at(vec2 pixel) {
  return mat3(camera_to_world) * view_ray((pixel + 0.5) * viewport.zw);
}

vec2 ground_place_at(vec2 pixel) {
  vec3 direction = direction_at(pixel);
  float along;
  return meets_ground(eye.xyz, direction, along) ? ground_place(eye.xyz + along * direction) : vec2(1e4);
}

vec3 ground_at(ivec2 pixel, vec3 world, vec3 direction) {
  // As far as the next pixel, which may see beyond the ground's end.
  vec2 here = ground_place(world);
  vec2 wide = abs(ground_place_at(vec2(pixel.x ^ 1, pixel.y)) - here) + abs(ground_place_at(vec2(pixel.x, pixel.y ^ 1)) - here);
  return ground_color(world, direction, wide);
}

// And how far away it is.
vec3 color_at(ivec2 pixel, out float distance) {
  vec3 direction = direction_at(vec2(pixel));
  float depth = texelFetch(scene_depth, pixel, 0).r;
  if (depth < 1.0) {  // else nothing stands here
    distance = to_distance(depth);
    vec4 albedo = texelFetch(albedos, pixel, 0);
    return lit(albedo.rgb, albedo.a, eye.xyz + distance * direction, normalize(texelFetch(normals, pixel, 0).xyz));
  }
  if (meets_ground(eye.xyz, direction, distance)) return ground_at(pixel, eye.xyz + distance * direction, normalize(direction));
  distance = 1e30;
  return sky(normalize(direction));
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (is_outside(pixel)) return;
  float distance;
  imageStore(scene_color, pixel, vec4(color_at(pixel, distance), 1.0));
  imageStore(scene_distance, pixel, vec4(distance));
}
