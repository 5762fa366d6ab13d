// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// How much of the sun's light comes to a place: solids hold it off, and fluid dyes it.
layout(binding = 0) uniform sampler2DShadow shadow_map;
layout(binding = 13) uniform sampler2D shadow_depths;     // the same, as depths
layout(binding = 15) uniform sampler2D shadow_spans;      // least and greatest depths, see light/shadow_blocks.comp.glsl
layout(binding = 1) uniform sampler2D fluid_shadow_map;  // of the front layer: absorbance; the nearest depth
layout(binding = 12) uniform sampler2D rest_shadow_map;  // likewise, of the fluid behind it

#include "caustics/caustics.glsl"

// Shadows get softer with the distance to what casts them, as in light from a disc (Fernando 2005, Percentage-Closer
// Soft Shadows).
const float sun_width = 0.03;  // m of half-shade for each metre from what casts it: a sun in thin haze
const float least_soft = 5.0, most_soft = 24.0;  // texels
const float last_depth = 0.9999;  // the ground goes on behind all that casts shadows

// The least and the greatest depth of the solids within 12 texels, from blocks of 8 × 8.
vec2 depth_span(vec2 at) {
  ivec2 last = textureSize(shadow_spans, 0) - 1, middle = ivec2(floor(at * vec2(last + 1)));
  vec2 span = vec2(1.0, 0.0);
  for (int k = 0; k < 25; ++k) {
    vec2 found = texelFetch(shadow_spans, clamp(middle + ivec2(k % 5, k / 5) - 2, ivec2(0), last), 0).rg;
    span = vec2(min(span.x, found.x), max(span.y, found.y));
  }
  return span;
}

// Mean depth of what is nearer to the sun than the place, from 100 texels around it. x: how many of them are nearer.
vec2 nearer_depth(vec3 at, vec2 slope, vec2 size) {
  float count = 0.0, sum = 0.0;
  for (int k = 0; k < 25; ++k) {
    vec2 apart = 5.5 * vec2(k % 5 - 2, k / 5 - 2) / size;
    vec4 depths = textureGather(shadow_depths, at.xy + apart);
    vec4 nearer = vec4(lessThan(depths, vec4(min(at.z + dot(slope, apart), last_depth))));
    count += dot(nearer, vec4(1.0));
    sum += dot(nearer, depths);
  }
  return vec2(count, sum / max(count, 1.0));
}

// `slope`: how the depth of the surface changes along the map.
float solid_light(vec3 at, vec2 slope) {
  vec2 size = vec2(textureSize(shadow_map, 0)), span = depth_span(at.xy);
  float rise = dot(abs(slope), 0.5 * most_soft / size);
  if (span.x >= min(at.z + rise, last_depth)) return 1.0;
  if (span.y < min(at.z - rise, last_depth)) return 0.0;
  vec2 found = nearer_depth(at, slope, size);
  if (found.x == 0.0 || found.x == 100.0) return found.x == 0.0 ? 1.0 : 0.0;
  // The map is as deep as it is wide.
  float soft = clamp((at.z - found.y) * size.x * sun_width, least_soft, most_soft), light = 0.0;
  for (int k = 0; k < 81; ++k) {
    ivec2 step = ivec2(k % 9, k / 9) - 4;
    vec2 apart = soft / 9.0 * vec2(step) / size;
    float weight = float((5 - abs(step.x)) * (5 - abs(step.y)));
    light += weight * textureLod(shadow_map, vec3(at.xy + apart, min(at.z + dot(slope, apart), last_depth)), 0.0);
  }
  return light / 625.0;
}

// How much of a layer the light has passed, from its nearest depth: all of it, or as far as it came.
float passed_share(float depth) {
  return clamp(to_sun.w * depth / floor_.z - 0.5, 0.0, 1.0);
}

// What fluid leaves of the light. Texels that show different layers are not mixed before it is known what they leave.
vec3 fluid_light(vec3 at) {
  vec2 place = at.xy * vec2(textureSize(fluid_shadow_map, 0)) - 0.5, part = fract(place);
  ivec2 first = ivec2(floor(place)), last = textureSize(fluid_shadow_map, 0) - 1;
  vec3 light = vec3(0.0);
  float below = 0.0;  // how much of the light has passed the first surface
  for (int k = 0; k < 4; ++k) {
    ivec2 texel = clamp(first + ivec2(k & 1, k >> 1), ivec2(0), last);
    vec4 front = texelFetch(fluid_shadow_map, texel, 0), rest = texelFetch(rest_shadow_map, texel, 0);
    vec3 absorbed = passed_share(at.z - front.a) * front.rgb + passed_share(at.z - rest.a) * rest.rgb;
    float weight = ((k & 1) == 1 ? part.x : 1.0 - part.x) * (k > 1 ? part.y : 1.0 - part.y);
    light += weight * exp(-absorbed);
    if (front.a < 1.0) below += weight * passed_share(at.z - front.a);  // 1: no fluid
  }
  return up.w > 0.5 && below > 0.0 ? light * mix(1.0, gathered_light(at.xy), below) : light;
}

vec3 sun_on(vec3 world, vec3 normal) {
  float texel = 2.0 * to_sun.w / float(textureSize(shadow_map, 0).x);
  vec4 clip = world_to_sun * vec4(world + 2.5 * texel * normal, 1.0);
  vec3 at = 0.5 * clip.xyz + 0.5;
  if (any(lessThan(at.xy, vec2(0.0))) || any(greaterThan(at.xy, vec2(1.0)))) return vec3(1.0);
  vec3 left = fluid_light(at);
  // Along the surface, but not beyond 60° to the sun's rays.
  vec3 there = mat3(world_to_sun) * normal;
  vec2 slope = there.z < 0.0 ? -there.xy / min(there.z, -0.5 * length(there)) : vec2(0.0);
  return solid_light(at, slope) * left;
}
