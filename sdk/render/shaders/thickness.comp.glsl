// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// How much fluid lies along each line of sight of one tile. Each particle's volume is spread as (1 − r²/R²)² over a
// disc: smooth, and all of it is there. Sums are of whole numbers, which add up to the same in any order.
#include "frame.glsl"
#include "fluids.glsl"
#include "particles.glsl"
#include "disc.glsl"
#include "tiles.glsl"
#include "team.glsl"
layout(local_size_x = 256) in;
layout(binding = 3) uniform sampler2D scene_distance;  // of the camera alone
layout(binding = 0, rgba32f) writeonly restrict uniform image2D sums;  // absorbance; metres, or the smallest depth
layout(location = 0) uniform ivec2 tiles;
layout(location = 1) uniform mat4 to_clip;    // of the world
layout(location = 2) uniform vec2 per_metre;  // clip space at distance 1
layout(location = 3) uniform float radius;    // m, of the disc
layout(location = 4) uniform int hides;       // 1: what lies behind a solid does not count

const int size = 16;
const float parts = 65536.0;  // of a spacing's length
const float most = 4.0;       // absorbance, along the path that colours are given for

shared uint metres[size * size], red[size * size], green[size * size], blue[size * size];
shared uint nearest[size * size];  // depth, of the sun's
shared float behind[size * size];  // distance of the scene, of the camera's
shared uint lowest_fluid, highest_fluid;

// On the path that the colour is given for the colour is left of the light; what is all black would take in all at once.
vec3 absorbance_of(uint fluid) {
  return -log(clamp(look_of(fluid).rgb, 0.02, 0.98));
}

void add(uint i, ivec2 corner, ivec2 last, ivec2 first, ivec2 steps) {
  vec4 clip = to_clip * vec4(centre_of(i), 1.0);
  vec2 reach = radius * per_metre;
  ivec4 pixels = disc_pixels(clip, reach, last + 1) - corner.xyxy;
  pixels = ivec4(max(pixels.xy, 0), min(pixels.zw, size - 1));
  float depth = 0.5 * clip.z / clip.w + 0.5;
  vec2 middle = (0.5 * clip.xy / clip.w + 0.5) * vec2(last + 1) - 0.5 - vec2(corner), scale = 2.0 * clip.w / (reach * vec2(last + 1));
  float amount = parts * floor_.z * floor_.z * 3.0 / (3.14159265 * radius * radius);
  bool is_one_fluid = lowest_fluid == highest_fluid;
  vec3 absorbance = is_one_fluid ? vec3(0.0) : absorbance_of(fluid_indices[i]) / most;
  for (int y = pixels.y + first.y; y <= pixels.w; y += steps.y) {
    for (int x = pixels.x + first.x; x <= pixels.z; x += steps.x) {
      int k = y * size + x;
      vec2 offset = (vec2(x, y) - middle) * scale;
      float u = 1.0 - dot(offset, offset);
      if (u <= 0.0 || (hides == 1 && clip.w > behind[k])) continue;
      float part = amount * u * u;
      atomicAdd(metres[k], uint(part + 0.5));
      // As a ball would have it, behind whose top the disc is hung: steps from disc to disc would be seen as shades.
      if (hides == 0) atomicMin(nearest[k], floatBitsToUint(max(depth + 0.5 * radius / to_sun.w * (1.0 - sqrt(u)), 0.0)));
      if (is_one_fluid) continue;
      uvec3 dyed = uvec3(part * absorbance + 0.5);
      atomicAdd(red[k], dyed.r);
      atomicAdd(green[k], dyed.g);
      atomicAdd(blue[k], dyed.b);
    }
  }
}

void note_fluids(int list) {
  uint begin = list_begin(list), count = list_count(list);
  for (uint k = gl_LocalInvocationID.x; k < count; k += group_size) {
    uint fluid = fluid_indices[tile_entries[begin + k]];
    if (fluid < lowest_fluid) atomicMin(lowest_fluid, fluid);
    if (fluid > highest_fluid) atomicMax(highest_fluid, fluid);
  }
}

void add_list(int list, ivec2 corner, ivec2 last) {
  uint begin = list_begin(list), count = list_count(list);
  Team team = team_for(count);
  for (uint k = gl_LocalInvocationID.x; k < team.size * count; k += group_size)
    add(tile_entries[begin + k / team.size], corner, last, offset_in(team, k), team.steps);
}

void main() {
  int k = int(gl_LocalInvocationID.x), own = int(gl_WorkGroupID.y) * tiles.x + int(gl_WorkGroupID.x), all = tiles.x * tiles.y;
  ivec2 corner = ivec2(gl_WorkGroupID.xy) * size, pixel = corner + ivec2(k % size, k / size), last = imageSize(sums) - 1;
  metres[k] = red[k] = green[k] = blue[k] = 0u;
  nearest[k] = floatBitsToUint(1.0);
  behind[k] = hides == 1 ? texelFetch(scene_distance, min(2 * pixel + 1, textureSize(scene_distance, 0) - 1), 0).r : 0.0;
  lowest_fluid = ~0u;
  highest_fluid = 0u;
  barrier();
  note_fluids(own);
  note_fluids(all);
  barrier();
  add_list(own, corner, last);
  add_list(all, corner, last);
  barrier();
  float length = float(metres[k]) * (floor_.z / parts);
  vec3 dyed = vec3(red[k], green[k], blue[k]) * (floor_.z / parts * most);
  if (lowest_fluid == highest_fluid) dyed = length * absorbance_of(lowest_fluid);
  imageStore(sums, pixel, vec4(dyed / centre.w, hides == 1 ? length : uintBitsToFloat(nearest[k])));
}
