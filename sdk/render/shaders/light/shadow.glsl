// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// How much of the sun's light comes to a place: solids hold it off, and fluid dyes it.
layout(binding = 0) uniform sampler2DShadow shadow_map;
layout(binding = 1) uniform sampler2D fluid_shadow_map;  // of the front layer: absorbance; the nearest depth
layout(binding = 12) uniform sampler2D rest_shadow_map;  // likewise, of the fluid behind it

float solid_light(vec3 at) {
  vec2 size = vec2(textureSize(shadow_map, 0)), corner = at.xy * size - 2.0;
  vec2 first = floor(corner), part = corner - first;
  // Soft over five texels, of which the first and the last count in part; taps blend two each way, but for the last.
  vec2 places[3] = vec2[]((first + 0.5 + 1.0 / (2.0 - part)) / size, (first + 3.0) / size, (first + 4.5) / size);
  vec2 weights[3] = vec2[](2.0 - part, vec2(2.0), part);
  float taps[9];
  for (int k = 0; k < 9; k += 2) taps[k] = textureLod(shadow_map, vec3(places[k % 3].x, places[k / 3].y, at.z), 0.0);
  // Where the corners and the middle are alike, so is the rest, mostly.
  float few = taps[0] + taps[2] + taps[4] + taps[6] + taps[8];
  if (few == 0.0 || few == 5.0) return taps[4];
  for (int k = 1; k < 9; k += 2) taps[k] = textureLod(shadow_map, vec3(places[k % 3].x, places[k / 3].y, at.z), 0.0);
  float light = 0.0;
  for (int k = 0; k < 9; ++k) light += weights[k % 3].x * weights[k / 3].y * taps[k];
  return light / 16.0;
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
  for (int k = 0; k < 4; ++k) {
    ivec2 texel = clamp(first + ivec2(k & 1, k >> 1), ivec2(0), last);
    vec4 front = texelFetch(fluid_shadow_map, texel, 0), rest = texelFetch(rest_shadow_map, texel, 0);
    vec3 absorbed = passed_share(at.z - front.a) * front.rgb + passed_share(at.z - rest.a) * rest.rgb;
    light += ((k & 1) == 1 ? part.x : 1.0 - part.x) * (k > 1 ? part.y : 1.0 - part.y) * exp(-absorbed);
  }
  return light;
}

vec3 sun_on(vec3 world, vec3 normal) {
  float texel = 2.0 * to_sun.w / float(textureSize(shadow_map, 0).x);
  vec4 clip = world_to_sun * vec4(world + 2.5 * texel * normal, 1.0);
  vec3 at = 0.5 * clip.xyz + 0.5;
  if (any(lessThan(at.xy, vec2(0.0))) || any(greaterThan(at.xy, vec2(1.0)))) return vec3(1.0);
  vec3 left = fluid_light(at);
  at.z = min(at.z, 0.9999);  // the ground goes on behind all that casts shadows
  return solid_light(at) * left;
}
