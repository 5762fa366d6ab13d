// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// The ellipsoids of one tile by ray casting: in red where the line of sight first enters one, as a distance along −z,
// 0 where there is none; in green how much of the filter that one is to get.
#include "frame.glsl"
#include "fluids.glsl"
#include "quadric.glsl"
#include "particles.glsl"
#include "ellipsoid.glsl"
#include "tiles.glsl"
#include "team.glsl"
layout(local_size_x = 256) in;
layout(binding = 3) uniform sampler2D scene_distance;
layout(binding = 0, rg32f) writeonly restrict uniform image2D surface;
layout(location = 0) uniform ivec2 tiles;

const int size = 32;
const uint share_bits = 63u;  // of a distance's bits, the last: they hold the filter's share instead

const int block = 8;                   // pixels
const int blocks = size / block;

shared uint nearest[size * size];
shared uint farthest[blocks * blocks];  // no pixel of the block shows anything further away

// What the scene hides is further away; of equal ones the scene comes last.
uint limit_at(ivec2 pixel) {
  ivec2 last = ivec2(viewport.xy) - 1;
  return floatBitsToUint(texelFetch(scene_distance, min(pixel, last), 0).r) | share_bits;
}

ivec4 in_tile(ivec4 pixels, ivec2 corner) {
  return ivec4(max(pixels.xy - corner, 0), min(pixels.zw - corner, size - 1));
}

// Also where there are no pixels.
bool is_hidden(ivec4 pixels, uint least) {
  if (pixels.x > pixels.z || pixels.y > pixels.w) return true;
  pixels /= block;
  for (int y = pixels.y; y <= pixels.w; ++y) {
    for (int x = pixels.x; x <= pixels.z; ++x) {
      if (farthest[y * blocks + x] >= least) return false;
    }
  }
  return true;
}

// A thread's share of its pixels.
void draw(uint i, ivec2 corner, ivec2 offset, ivec2 steps) {
  Particle p = particle(i);
  vec3 middle = (view * vec4(p.centre, 1.0)).xyz;
  float reach = longest(p.radii);
  if (!is_seen(middle, reach)) return;
  uint least = floatBitsToUint(0.9999 * (-middle.z - reach));
  if (is_hidden(in_tile(pixels_of_ball(middle, reach), corner), least)) return;
  mat3 turn = turn_of(p.rotation);
  ivec4 pixels = in_tile(pixels_of(p, turn, middle), corner);

  // In the space where the ellipsoid is the unit ball: the eye, and the line of sight per unit of distance.
  mat3 inverse_axes = transpose(mat3(turn[0] / p.radii.x, turn[1] / p.radii.y, turn[2] / p.radii.z));
  vec3 from = -(inverse_axes * middle);
  vec2 pixel = 2.0 * viewport.zw * lens.xy;
  vec3 along_x = inverse_axes[0] * pixel.x, along_y = inverse_axes[1] * pixel.y;
  vec3 first = inverse_axes * vec3((vec2(corner) + 0.5) * pixel - lens.xy, -1.0);
  // A drop on its own, which is smaller than what has neighbours, is to keep its shape.
  float evenness = mix(0.2, 1.0, smoothstep(0.65, 0.95, pow(p.radii.x * p.radii.y * p.radii.z, 1.0 / 3.0) / floor_.z));
  uint share = uint(evenness * float(share_bits) + 0.5);

  for (int y = pixels.y + offset.y; y <= pixels.w; y += steps.y) {
    for (int x = pixels.x + offset.x; x <= pixels.z; x += steps.x) {
      if (nearest[y * size + x] < least) continue;
      vec3 direction = first + float(x) * along_x + float(y) * along_y;
      // From the point nearest to the centre: exact however far the eye is.
      float square = dot(direction, direction);
      float halfway = -dot(from, direction) / square;
      vec3 closest = from + halfway * direction;
      float inside = 1.0 - dot(closest, closest);
      if (inside < 0.0) continue;
      float distance = halfway - sqrt(inside / square);
      atomicMin(nearest[y * size + x], (floatBitsToUint(distance) & ~share_bits) | share);
    }
  }
}

void find_farthest() {
  barrier();
  for (uint k = gl_LocalInvocationID.x; k < uint(blocks * blocks); k += group_size) farthest[k] = 0u;
  barrier();
  for (int k = int(gl_LocalInvocationID.x); k < size * size; k += int(group_size))
    atomicMax(farthest[(k / size / block) * blocks + k % size / block], nearest[k]);
  barrier();
}

// Some of each part of the list in each round: after the first, most of what is inside of the fluid is hidden.
void draw_list(int list, ivec2 corner) {
  uint begin = list_begin(list), count = list_count(list), rounds = clamp(count / 128u, 1u, 4u);
  for (uint round = 0u; round < rounds; ++round) {
    uint drawn = (count + rounds - 1u - round) / rounds;
    Team team = team_for(drawn);
    for (uint k = gl_LocalInvocationID.x; k < team.size * drawn; k += group_size)
      draw(tile_entries[begin + k / team.size * rounds + round], corner, offset_in(team, k), team.steps);
    find_farthest();
  }
}

void put(ivec2 pixel, uint found) {
  bool is_fluid = found < limit_at(pixel);
  vec2 value = vec2(uintBitsToFloat(found & ~share_bits), float(found & share_bits) / float(share_bits));
  imageStore(surface, pixel, vec4(is_fluid ? value : vec2(0.0), 0.0, 0.0));
}

void main() {
  int own = int(gl_WorkGroupID.y) * tiles.x + int(gl_WorkGroupID.x), all = tiles.x * tiles.y, first = int(gl_LocalInvocationID.x);
  ivec2 corner = ivec2(gl_WorkGroupID.xy) * size;
  if (list_count(own) + list_count(all) == 0u) {
    for (int k = first; k < size * size; k += int(group_size)) imageStore(surface, corner + ivec2(k % size, k / size), vec4(0.0));
    return;
  }
  for (int k = first; k < size * size; k += int(group_size)) nearest[k] = limit_at(corner + ivec2(k % size, k / size));
  find_farthest();
  draw_list(own, corner);
  draw_list(all, corner);
  for (int k = first; k < size * size; k += int(group_size)) put(corner + ivec2(k % size, k / size), nearest[k]);
}
