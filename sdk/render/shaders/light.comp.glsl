// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Light on what is there: what stands in the scene, the ground, which fades into the sky, and that.
#include "frame.glsl"
#include "pixels.glsl"
#include "mark.glsl"
#include "sky.glsl"
#include "shadow.glsl"
#include "material.glsl"
#include "ground.glsl"
#include "ground_color.glsl"
layout(binding = 2) uniform sampler2D albedos;  // a: gloss
layout(binding = 3) uniform sampler2D scene_distance;
layout(binding = 8) uniform sampler2D normals;
layout(binding = 9) uniform sampler2D glass;  // what its walls add; a: the share that they let pass
layout(binding = 0, rgba16f) writeonly restrict uniform image2D scene_color;

vec2 ground_place_at(vec2 pixel) {
  vec3 direction = world_ray(pixel);
  float along;
  return meets_ground(eye.xyz, direction, along) ? ground_place(eye.xyz + along * direction) : vec2(1e4);
}

vec3 ground_at(ivec2 pixel, vec3 world, vec3 direction) {
  // As far as the next pixel, which may see beyond the ground's end.
  vec2 here = ground_place(world);
  vec2 wide = abs(ground_place_at(vec2(pixel.x ^ 1, pixel.y)) - here);
  wide += abs(ground_place_at(vec2(pixel.x, pixel.y ^ 1)) - here);
  return ground_color(world, direction, wide);
}

vec3 color_at(ivec2 pixel) {
  float distance = texelFetch(scene_distance, pixel, 0).r;
  vec3 direction = world_ray(vec2(pixel)), world = eye.xyz + distance * direction;
  if (!is_marked(distance)) {
    vec4 albedo = texelFetch(albedos, pixel, 0);
    return lit(albedo.rgb, albedo.a, world, normalize(texelFetch(normals, pixel, 0).xyz));
  }
  return distance < 1e29 ? ground_at(pixel, world, normalize(direction)) : sky(normalize(direction));
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (is_outside(pixel)) return;
  vec4 before = texelFetch(glass, pixel, 0);
  imageStore(scene_color, pixel, vec4(before.a * color_at(pixel) + before.rgb, 1.0));
}
