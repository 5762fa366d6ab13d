// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A bundle of light for each texel of the sun's map: where fluid bends it to, as seen from the sun. Bundles are whole
// numbers, which add up to the same in any order.
#include "shared/frame.glsl"
#include "caustics/bundles.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 2) uniform sampler2D surface;         // depths, 0 to 1; 2: no fluid
layout(binding = 13) uniform sampler2D shadow_depths;  // of solids
layout(binding = 0, r32ui) restrict uniform uimage2D bundles;

// Depth of what the light falls on: solids, or the ground.
float floor_depth(vec2 at, float depth) {
  vec3 normal = mat3(world_to_sun) * ground.xyz;
  vec4 point = world_to_sun * vec4(ground.w * ground.xyz, 1.0);
  vec2 clip = 2.0 * at - 1.0;
  float ground_depth = 0.5 * (point.z - dot(normal.xy, clip - point.xy) / min(normal.z, -1e-6)) + 0.5;
  return min(textureLod(shadow_depths, at, 0.0).r, max(ground_depth, depth));
}

void add(ivec2 texel, float share, ivec2 size) {
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, size))) return;
  imageAtomicAdd(bundles, texel, uint(share * whole_bundle + 0.5));
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(bundles), last = size - 1;
  float here = texelFetch(surface, texel, 0).r;
  if (here > 1.0) return;
  float slopes[2] = float[](0.0, 0.0);
  for (int axis = 0; axis < 2; ++axis) {
    ivec2 step = ivec2(1 - axis, axis);
    float a = texelFetch(surface, clamp(texel - step, ivec2(0), last), 0).r;
    float b = texelFetch(surface, clamp(texel + step, ivec2(0), last), 0).r;
    if (a < 1.0 && b < 1.0) slopes[axis] = 0.5 * (b - a) * float(size.x);
  }
  vec2 at = (vec2(texel) + 0.5) / vec2(size);
  float way = floor_depth(at, here) - here;
  if (way <= 0.0) return;  // something stands before the fluid
  vec3 bent = refract(vec3(0.0, 0.0, 1.0), normalize(vec3(slopes[0], slopes[1], -1.0)), 1.0 / 1.333);
  vec2 place = (at + way * bent.xy / max(bent.z, 0.2)) * vec2(size) - 0.5, part = fract(place);
  ivec2 first = ivec2(floor(place));
  for (int k = 0; k < 4; ++k) {
    float share = ((k & 1) == 1 ? part.x : 1.0 - part.x) * (k > 1 ? part.y : 1.0 - part.y);
    add(first + ivec2(k & 1, k >> 1), share, size);
  }
}
