// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// How much fluid lies along each line of sight of a block, a quarter of a tile. Each particle's volume is spread as
// (1 − r²/R²)² over a disc: smooth, and all of it is there. Threads take a particle each and write down the discs that
// reach the block; then each sums up some of them for four pixels, so that it reads a disc once for all four. Sums are
// of whole numbers, which add up to the same in any order. The block also notes which slices of depth hold fluid, and
// sums up what lies before the first gap once more.
#include "shared/frame.glsl"
#include "particles/fluids.glsl"
#include "particles/particles.glsl"
#include "particles/disc.glsl"
#include "tiles/tiles.glsl"
#include "fluid/fluid_depth.glsl"
#include "fluid/layers.glsl"
layout(local_size_x = 128) in;
layout(binding = 3) uniform sampler2D scene_distance;  // of the camera alone
layout(binding = 0, rgba32f) writeonly restrict uniform image2D sums;  // of the front layer: absorbance; metres for
                                                                       // the camera, the least depth for the sun
layout(binding = 1, rgba32f) writeonly restrict uniform image2D rest;  // likewise, of what is behind it
layout(binding = 2, rgba32ui) writeonly restrict uniform uimage2D layer_slices;  // see fluid/front_and_rest.glsl
layout(location = 0) uniform ivec2 tiles;
layout(location = 1) uniform mat4 to_clip;    // of the world
layout(location = 2) uniform vec2 per_metre;  // clip space at distance 1
layout(location = 3) uniform float radius;    // m, of the disc
layout(location = 4) uniform int hides;       // 1: what lies behind a solid does not count

const uint group_size = 128u;
const int size = 8;  // of a block, pixels
const uint pixels = uint(size * size), quads = pixels / 4u, parts = group_size / quads;  // of the discs
const float units = 65536.0;  // of a spacing's length
const float most = 4.0;       // absorbance, along the path that colours are given for; media have more

shared vec4 discs[group_size];  // from pixels of the block to the disc's radii: scale, and what to add
shared float distances[group_size];  // along −z, m
shared vec3 absorbances[group_size], returns[group_size];  // of several fluids
shared uint disc_count;
shared int metres[pixels], dyes[6][pixels];  // absorbance, and glow, of red, green and blue
shared uint nearest[pixels];  // distance, m; of the sun's
shared uint slices[pixels];
shared float starts[pixels];  // distance of the first surface, m
shared uint lowest_fluid, highest_fluid;
shared bool has_layers;

void look_at(uint i, ivec2 corner, ivec2 all) {
  vec4 clip = to_clip * vec4(centre_of(i), 1.0);
  vec2 reach = radius * per_metre;
  ivec4 covered = disc_pixels(clip, reach, all);
  if (any(greaterThan(covered.xy, min(covered.zw, corner + size - 1))) || any(lessThan(covered.zw, corner))) return;
  uint place = atomicAdd(disc_count, 1u);
  vec2 scale = 2.0 * clip.w / (reach * vec2(all)), middle = (0.5 * clip.xy / clip.w + 0.5) * vec2(all) - 0.5;
  discs[place] = vec4(scale, (vec2(corner) - middle) * scale);
  distances[place] = hides == 1 ? clip.w : (clip.z / clip.w + 1.0) * to_sun.w;
  if (lowest_fluid == highest_fluid) return;
  absorbances[place] = extinction_of(fluid_indices[i]) / most;
  returns[place] = glow_of(fluid_indices[i]);
}

// Of four pixels, two by two.
struct Sums {
  ivec4 metres, dyes[6];
  vec4 nearest;
  uvec4 slices;
};
const ivec4 no_dyes[6] = ivec4[](ivec4(0), ivec4(0), ivec4(0), ivec4(0), ivec4(0), ivec4(0));
const Sums no_sums = Sums(ivec4(0), no_dyes, vec4(no_gap), uvec4(0u));
const int amounts = 1, first_depths = 2, depth_slices = 4;  // what a pass over the discs finds; may be added up

// A ball of one spacing, within the disc of `radius`: balls of neighbours leave no gap between them.
uvec4 slices_of(vec4 u, float distance, vec4 start) {
  vec4 square = floor_.z * floor_.z - (1.0 - u) * radius * radius;
  vec4 half_way = sqrt(max(square, 0.0)), beyond = distance - start;
  uvec4 met = slices_between(slice_at(beyond - half_way), slice_at(beyond + half_way));
  return met * uvec4(greaterThan(square, vec4(0.0)));
}

vec4 amount_at(vec4 u) {
  return units * floor_.z * floor_.z * 3.0 / (3.14159265 * radius * radius) * u * u;
}

// `x` and `y` in the block; `behind`: the distance of what hides fluid.
void add_discs(inout Sums own, int finds, vec4 x, vec4 y, vec4 behind, vec4 start) {
  for (uint k = gl_LocalInvocationID.x / quads; k < disc_count; k += parts) {
    vec4 disc = discs[k], right = x * disc.x + disc.z, up_ = y * disc.y + disc.w;
    float distance = distances[k];
    vec4 u = max(1.0 - right * right - up_ * up_, 0.0);
    bvec4 is_hidden = lessThan(behind, vec4(distance));
    if ((finds & depth_slices) != 0) own.slices |= slices_of(u, distance, start) * uvec4(not(is_hidden));
    // As a ball would have it, behind whose top the disc is hung: steps from disc to disc would be seen as shades.
    if ((finds & first_depths) != 0) {
      vec4 depth = distance + radius * (1.0 - sqrt(u));
      own.nearest = min(own.nearest, mix(vec4(no_gap), depth, greaterThan(u, vec4(0.0))));
    }
    if ((finds & amounts) != 0) own.metres += ivec4(mix(amount_at(u), vec4(0.0), is_hidden) + 0.5);
  }
}

// Likewise, what several fluids differ in. Apart, since Mesa's rasteriser skips loops but no branches.
void add_dyes(inout Sums own, vec4 x, vec4 y, vec4 behind) {
  uint count = lowest_fluid == highest_fluid ? 0u : disc_count;
  for (uint k = gl_LocalInvocationID.x / quads; k < count; k += parts) {
    vec4 disc = discs[k], right = x * disc.x + disc.z, up_ = y * disc.y + disc.w;
    vec4 u = max(1.0 - right * right - up_ * up_, 0.0);
    vec4 part = mix(amount_at(u), vec4(0.0), lessThan(behind, vec4(distances[k])));
    for (int c = 0; c < 3; ++c) {
      own.dyes[c] += ivec4(part * absorbances[k][c] + 0.5);
      own.dyes[3 + c] += ivec4(part * returns[k][c] + 0.5);
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

void add_list(int list, int finds, ivec2 corner, ivec2 all, ivec2 place, vec4 behind, inout Sums own) {
  uint begin = list_begin(list), end = begin + list_count(list), self = gl_LocalInvocationID.x;
  vec4 x = vec4(place.x) + vec4(0.0, 1.0, 0.0, 1.0), y = vec4(place.y) + vec4(0.0, 0.0, 1.0, 1.0);
  int k = place.y * size + place.x;
  vec4 start = vec4(starts[k], starts[k + 1], starts[k + size], starts[k + size + 1]);
  for (; begin < end; begin += group_size) {
    if (begin + self < end) look_at(tile_entries[begin + self], corner, all);
    barrier();
    add_discs(own, finds, x, y, behind, start);
    if ((finds & amounts) != 0) add_dyes(own, x, y, behind);
    barrier();
    if (self == 0u) disc_count = 0u;
    barrier();
  }
}

void add_up(ivec2 place, Sums own) {
  for (int i = 0; i < 4; ++i) {
    int k = (place.y + i / 2) * size + place.x + i % 2;
    if (own.slices[i] != 0u) atomicOr(slices[k], own.slices[i]);
    if (own.nearest[i] < no_gap) atomicMin(nearest[k], floatBitsToUint(max(own.nearest[i], 0.0)));
    if (own.metres[i] == 0) continue;
    atomicAdd(metres[k], own.metres[i]);
    if (lowest_fluid == highest_fluid) continue;
    for (int c = 0; c < 6; ++c) atomicAdd(dyes[c][k], own.dyes[c][i]);
  }
}

// All discs of the block; the results are in shared memory.
void find(int finds, ivec2 place, vec4 behind) {
  int list = int(gl_WorkGroupID.y / 2u) * tiles.x + int(gl_WorkGroupID.x / 2u);
  ivec2 corner = ivec2(gl_WorkGroupID.xy) * size, all = imageSize(sums);
  Sums own = no_sums;
  add_list(list, finds, corner, all, place, behind, own);
  add_list(tiles.x * tiles.y, finds, corner, all, place, behind, own);
  add_up(place, own);
  barrier();
}

// Of pixels of the sums; without solids that hide fluid beyond all depths.
float hidden_from(ivec2 pixel) {
  return hides == 1 ? texelFetch(scene_distance, min(2 * pixel + 1, textureSize(scene_distance, 0) - 1), 0).r : no_gap;
}

// Of the four pixels of the picture; no_gap where there is no surface.
float first_surface(ivec2 pixel) {
  float nearest = no_gap;
  for (int k = 0; k < 4; ++k) {
    float found = fluid_depth(2 * pixel + ivec2(k & 1, k >> 1));
    if (found > 0.0) nearest = min(nearest, found);
  }
  return nearest;
}

// What adds up along a line of sight.
struct Amounts {
  vec4 passed;  // absorbance; metres
  vec3 glow;    // times metres
};

const Amounts no_amounts = Amounts(vec4(0.0), vec3(0.0));

Amounts summed(uint k) {
  float metre = floor_.z / units, length = float(metres[k]) * metre;
  vec3 dyed = vec3(dyes[0][k], dyes[1][k], dyes[2][k]) * (metre * most);
  vec3 glow = vec3(dyes[3][k], dyes[4][k], dyes[5][k]) * metre;
  if (lowest_fluid == highest_fluid) {
    dyed = length * extinction_of(lowest_fluid);
    glow = length * glow_of(lowest_fluid);
  }
  return Amounts(vec4(dyed / centre.w, length), glow);
}

uint packed_glow(Amounts amounts) {
  return packed_glow(amounts.glow / max(amounts.passed.a, 1e-9));
}

// Distance at which the front layer has ended and the rest not begun, m.
float gap_at(ivec2 place) {
  int k = place.y * size + place.x;
  vec2 gap = gap_behind(slices[k]);
  return starts[k] < no_gap && gap.x < no_gap ? starts[k] + 0.5 * (gap.x + gap.y) : no_gap;
}

void clear(uint k) {
  metres[k] = 0;
  for (int c = 0; c < 6; ++c) dyes[c][k] = 0;
}

// Once the surface is known.
void start_at(uint k, float distance) {
  starts[k] = distance;
  slices[k] = distance < no_gap ? 1u : 0u;  // a surface has fluid behind it
}

float sun_depth(float distance) {
  return min(0.5 * distance / to_sun.w, 1.0);
}

void put(ivec2 pixel, uint k, Amounts front, Amounts total) {
  Amounts others = Amounts(total.passed - front.passed, total.glow - front.glow);
  if (hides == 0) {
    front.passed.a = sun_depth(starts[k]);
    others.passed.a = sun_depth(starts[k] + gap_behind(slices[k]).y);
  } else {
    imageStore(layer_slices, pixel, uvec4(floatBitsToUint(starts[k]), slices[k], packed_glow(front), packed_glow(others)));
  }
  imageStore(sums, pixel, front.passed);
  imageStore(rest, pixel, others.passed);
}

void main() {
  uint self = gl_LocalInvocationID.x;
  int list = int(gl_WorkGroupID.y / 2u) * tiles.x + int(gl_WorkGroupID.x / 2u), shared_list = tiles.x * tiles.y;
  ivec2 corner = ivec2(gl_WorkGroupID.xy) * size, pixel = corner + ivec2(int(self) % size, int(self) / size);
  if (self < pixels) {
    clear(self);
    nearest[self] = floatBitsToUint(no_gap);
    start_at(self, hides == 1 ? first_surface(pixel) : no_gap);
  }
  if (list_count(list) + list_count(shared_list) == 0u) {
    if (self < pixels) put(pixel, self, no_amounts, no_amounts);
    return;
  }
  lowest_fluid = ~0u;
  highest_fluid = 0u;
  disc_count = 0u;
  has_layers = false;
  int quad = int(self % quads);
  ivec2 place = 2 * ivec2(quad % (size / 2), quad / (size / 2)), first = corner + place;
  vec4 behind = vec4(hidden_from(first), hidden_from(first + ivec2(1, 0)), hidden_from(first + ivec2(0, 1)),
                     hidden_from(first + 1));
  barrier();
  note_fluids(list);
  note_fluids(shared_list);
  barrier();
  // What is found stands in the call: the compiler leaves out the rest.
  if (hides == 1)
    find(amounts + depth_slices, place, behind);
  else
    find(amounts + first_depths, place, behind);
  Amounts total = no_amounts;
  if (self < pixels) total = summed(self);
  Amounts front = total;
  if (hides == 0) {
    if (self < pixels) start_at(self, uintBitsToFloat(nearest[self]));
    barrier();
    find(depth_slices, place, behind);
  }
  vec4 gaps = vec4(gap_at(place), gap_at(place + ivec2(1, 0)), gap_at(place + ivec2(0, 1)), gap_at(place + 1));
  if (any(lessThan(gaps, vec4(no_gap)))) has_layers = true;
  if (self < pixels) clear(self);
  barrier();
  if (has_layers) {
    find(amounts, place, min(behind, gaps));
    if (self < pixels) front = summed(self);
  }
  if (self < pixels) put(pixel, self, front, total);
}
