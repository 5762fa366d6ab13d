// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// How much fluid lies along each line of sight of a block, a quarter of a tile. Each particle's volume is spread as
// (1 − r²/R²)² over a disc: smooth, and all of it is there. Threads take a particle each and write down the discs that
// reach the block; then each sums up some of them for four pixels, so that it reads a disc once for all four. Sums are
// of whole numbers, which add up to the same in any order.
#include "shared/frame.glsl"
#include "particles/fluids.glsl"
#include "particles/particles.glsl"
#include "particles/disc.glsl"
#include "tiles/tiles.glsl"
layout(local_size_x = 128) in;
layout(binding = 3) uniform sampler2D scene_distance;  // of the camera alone
layout(binding = 0, rgba32f) writeonly restrict uniform image2D sums;  // absorbance; metres, or the smallest depth
layout(location = 0) uniform ivec2 tiles;
layout(location = 1) uniform mat4 to_clip;    // of the world
layout(location = 2) uniform vec2 per_metre;  // clip space at distance 1
layout(location = 3) uniform float radius;    // m, of the disc
layout(location = 4) uniform int hides;       // 1: what lies behind a solid does not count

const uint group_size = 128u;
const int size = 8;  // of a block, pixels
const uint pixels = uint(size * size), quads = pixels / 4u, parts = group_size / quads;  // of the discs
const float units = 65536.0;  // of a spacing's length
const float most = 4.0;       // absorbance, along the path that colours are given for

shared vec4 discs[group_size];  // from pixels of the block to the disc's radii: scale, and what to add
shared float distances[group_size];  // along −z of the camera's, depths of the sun's
shared vec3 absorbances[group_size];
shared uint disc_count;
shared int metres[pixels], red[pixels], green[pixels], blue[pixels];
shared uint nearest[pixels];  // depth, of the sun's
shared uint lowest_fluid, highest_fluid;

// On the path that the colour is given for the colour is left of the light; all black would take in all at once.
vec3 absorbance_of(uint fluid) {
  return -log(clamp(look_of(fluid).rgb, 0.02, 0.98));
}

void look_at(uint i, ivec2 corner, ivec2 all) {
  vec4 clip = to_clip * vec4(centre_of(i), 1.0);
  vec2 reach = radius * per_metre;
  ivec4 covered = disc_pixels(clip, reach, all);
  if (any(greaterThan(covered.xy, min(covered.zw, corner + size - 1))) || any(lessThan(covered.zw, corner))) return;
  uint place = atomicAdd(disc_count, 1u);
  vec2 scale = 2.0 * clip.w / (reach * vec2(all)), middle = (0.5 * clip.xy / clip.w + 0.5) * vec2(all) - 0.5;
  discs[place] = vec4(scale, (vec2(corner) - middle) * scale);
  distances[place] = hides == 1 ? clip.w : 0.5 * clip.z / clip.w + 0.5;
  if (lowest_fluid < highest_fluid) absorbances[place] = absorbance_of(fluid_indices[i]) / most;
}

// Of four pixels, two by two.
struct Sums {
  ivec4 metres, red, green, blue;
  vec4 nearest;
};

// `x` and `y` in the block; `behind`: the distance of what hides fluid.
void add_discs(inout Sums own, vec4 x, vec4 y, vec4 behind) {
  float amount = units * floor_.z * floor_.z * 3.0 / (3.14159265 * radius * radius);
  float depth_of_radius = 0.5 * radius / to_sun.w;
  bool is_one_fluid = lowest_fluid == highest_fluid;
  for (uint k = gl_LocalInvocationID.x / quads; k < disc_count; k += parts) {
    vec4 disc = discs[k], right = x * disc.x + disc.z, up_ = y * disc.y + disc.w;
    float distance = distances[k];
    vec4 u = max(1.0 - right * right - up_ * up_, 0.0);
    vec4 part = mix(vec4(0.0), amount * u * u, greaterThanEqual(behind, vec4(distance)));
    own.metres += ivec4(part + 0.5);
    // As a ball would have it, behind whose top the disc is hung: steps from disc to disc would be seen as shades.
    if (hides == 0) {
      vec4 depth = distance + depth_of_radius * (1.0 - sqrt(u));
      own.nearest = min(own.nearest, mix(vec4(1.0), depth, greaterThan(u, vec4(0.0))));
    }
    if (is_one_fluid) continue;
    own.red += ivec4(part * absorbances[k].r + 0.5);
    own.green += ivec4(part * absorbances[k].g + 0.5);
    own.blue += ivec4(part * absorbances[k].b + 0.5);
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

void add_list(int list, ivec2 corner, ivec2 all, ivec2 place, vec4 behind, inout Sums own) {
  uint begin = list_begin(list), end = begin + list_count(list), self = gl_LocalInvocationID.x;
  vec4 x = vec4(place.x) + vec4(0.0, 1.0, 0.0, 1.0), y = vec4(place.y) + vec4(0.0, 0.0, 1.0, 1.0);
  for (; begin < end; begin += group_size) {
    if (begin + self < end) look_at(tile_entries[begin + self], corner, all);
    barrier();
    add_discs(own, x, y, behind);
    barrier();
    if (self == 0u) disc_count = 0u;
    barrier();
  }
}

void add_up(ivec2 place, Sums own) {
  for (int i = 0; i < 4; ++i) {
    int k = (place.y + i / 2) * size + place.x + i % 2;
    if (own.nearest[i] < 1.0) atomicMin(nearest[k], floatBitsToUint(max(own.nearest[i], 0.0)));
    if (own.metres[i] == 0) continue;
    atomicAdd(metres[k], own.metres[i]);
    if (lowest_fluid == highest_fluid) continue;
    atomicAdd(red[k], own.red[i]);
    atomicAdd(green[k], own.green[i]);
    atomicAdd(blue[k], own.blue[i]);
  }
}

// Of pixels of the sums; without solids that hide fluid beyond all depths.
float hidden_from(ivec2 pixel) {
  return hides == 1 ? texelFetch(scene_distance, min(2 * pixel + 1, textureSize(scene_distance, 0) - 1), 0).r : 2.0;
}

void put(ivec2 pixel, uint k) {
  float length = float(metres[k]) * (floor_.z / units);
  vec3 dyed = vec3(red[k], green[k], blue[k]) * (floor_.z / units * most);
  if (lowest_fluid == highest_fluid) dyed = length * absorbance_of(lowest_fluid);
  imageStore(sums, pixel, vec4(dyed / centre.w, hides == 1 ? length : uintBitsToFloat(nearest[k])));
}

void main() {
  uint self = gl_LocalInvocationID.x;
  int list = int(gl_WorkGroupID.y / 2u) * tiles.x + int(gl_WorkGroupID.x / 2u), shared_list = tiles.x * tiles.y;
  ivec2 corner = ivec2(gl_WorkGroupID.xy) * size, pixel = corner + ivec2(int(self) % size, int(self) / size);
  ivec2 all = imageSize(sums);
  if (list_count(list) + list_count(shared_list) == 0u) {
    if (self < pixels) imageStore(sums, pixel, vec4(0.0, 0.0, 0.0, hides == 1 ? 0.0 : 1.0));
    return;
  }
  if (self < pixels) {
    metres[self] = red[self] = green[self] = blue[self] = 0;
    nearest[self] = floatBitsToUint(1.0);
  }
  lowest_fluid = ~0u;
  highest_fluid = 0u;
  disc_count = 0u;
  int quad = int(self % quads);
  ivec2 place = 2 * ivec2(quad % (size / 2), quad / (size / 2)), first = corner + place;
  vec4 behind = vec4(hidden_from(first), hidden_from(first + ivec2(1, 0)), hidden_from(first + ivec2(0, 1)),
                     hidden_from(first + 1));
  barrier();
  note_fluids(list);
  note_fluids(shared_list);
  barrier();
  Sums own = Sums(ivec4(0), ivec4(0), ivec4(0), ivec4(0), vec4(1.0));
  add_list(list, corner, all, place, behind, own);
  add_list(shared_list, corner, all, place, behind, own);
  add_up(place, own);
  barrier();
  if (self < pixels) put(pixel, self);
}
