// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Light on what is there: what stands in the scene, the ground, which fades into the sky, and that; and glass before it.
#include "shared/frame.glsl"
#include "shared/pixels.glsl"
#include "light/sky.glsl"
#include "light/shadow.glsl"
#include "light/material.glsl"
#include "light/ground.glsl"
#include "light/ground_color.glsl"
#include "light/scene.glsl"
#include "light/vessels.glsl"
layout(binding = 2) uniform sampler2D albedos;         // a: gloss
layout(binding = 3) uniform sampler2D scene_distance;  // and what is there
#include "light/openness.glsl"
layout(binding = 8) uniform sampler2D normals;
layout(binding = 0, rgba16f) writeonly restrict uniform image2D scene_color;

// Where a plane is seen at a pixel, in tiles.
vec2 place_at(vec4 plane, vec2 pixel) {
  vec3 direction = world_ray(pixel);
  float along = (plane.w - dot(plane.xyz, eye.xyz)) / dot(plane.xyz, direction);
  return along > 0.0 ? tile_place(plane.xyz, eye.xyz + along * direction) : vec2(1e4);
}

// Of a pixel, as far as the next one, which may see beyond the plane's end.
vec2 width_at(vec4 plane, ivec2 pixel, vec2 here) {
  return abs(place_at(plane, vec2(pixel.x ^ 1, pixel.y)) - here) + abs(place_at(plane, vec2(pixel.x, pixel.y ^ 1)) - here);
}

vec3 floor_at(int face, ivec2 pixel, vec3 world) {
  vec3 normal = inward_normal(uint(face / 6), face % 6);
  vec2 here = tile_place(normal, world);
  vec3 albedo = tiles(here, width_at(vec4(normal, dot(normal, world)), pixel, here), vec3(0.24, 0.25, 0.26));
  normal = faceforward(normal, world - eye.xyz, normal);
  return lit(albedo, 0.05, 0.0, openness(pixel, world, normal), world, normal);
}

// A tint, and what walls mirror at low angles.
vec3 through_glass(vec3 color, vec3 direction, float distance) {
  for (uint k = 0u; k < vessel_count.x; ++k) {
    Passage p;
    if (!passes(k, direction, p) || p.leave < lens.z || p.leave >= distance) continue;
    if (!is_part(k, vessels[k].parts.x, p.leave_face, p.from + p.leave * p.direction)) continue;
    if (is_under_ground(eye.xyz + p.leave * direction, 1e-5 * floor_.y)) continue;
    vec3 n = inward_normal(k, p.leave_face), ahead = normalize(direction);
    float mirrored = 0.04 + 0.5 * pow(1.0 - abs(dot(n, ahead)), 5.0);
    vec3 light = mix(vec3(0.75, 0.86, 0.90) * ambient_light(n), clear_sky(dot(reflect(ahead, n), up.xyz)), 0.5);
    color = mix(color, light, clamp(0.06 + mirrored, 0.0, 0.5));
  }
  return color;
}

vec3 color_at(ivec2 pixel) {
  vec2 found = texelFetch(scene_distance, pixel, 0).rg;
  vec3 direction = world_ray(vec2(pixel)), ahead = normalize(direction), world = eye.xyz + found.r * direction, color;
  int what = int(found.g);
  if (what == is_nothing) {
    color = sky(ahead);
  } else if (what == is_ground) {
    color = ground_color(world, ahead, width_at(ground, pixel, tile_place(ground.xyz, world)),
                         openness(pixel, world, ground.xyz));
  } else if (what == is_solid) {
    vec4 albedo = texelFetch(albedos, pixel, 0), normal = texelFetch(normals, pixel, 0);
    normal.xyz = normalize(normal.xyz);
    color = lit(albedo.rgb, albedo.a, normal.a, openness(pixel, world, normal.xyz), world, normal.xyz);
  } else {
    color = floor_at(what - is_floor, pixel, world);
  }
  return through_glass(color, direction, what == is_ground ? 1e30 : found.r);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (!is_outside(pixel)) imageStore(scene_color, pixel, vec4(color_at(pixel), 1.0));
}
