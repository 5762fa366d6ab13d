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
layout(local_size_x = 256) in;
layout(binding = 3) uniform sampler2D solid_depth;  // of the camera alone
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
shared float behind[size * size];  // depth of the solids, of the camera's

void add(uint i, ivec2 corner, ivec2 last, int row, int step) {
  vec3 centre_ = centre_of(i);
  vec4 clip = to_clip * vec4(centre_, 1.0);
  vec2 reach = radius * per_metre;
  ivec4 pixels = disc_pixels(clip, reach, last + 1) - corner.xyxy;
  pixels = ivec4(max(pixels.xy, 0), min(pixels.zw, size - 1));
  float depth = 0.5 * clip.z / clip.w + 0.5;
  vec2 middle = (0.5 * clip.xy / clip.w + 0.5) * vec2(last + 1) - 0.5 - vec2(corner), scale = 2.0 * clip.w / (reach * vec2(last + 1));
  // On the path that the colour is given for the colour is left of the light; what is all black would take in all
  // at once.
  vec3 absorbance = -log(clamp(look_of(fluid_indices[i]).rgb, 0.02, 0.98)) / most;
  float amount = parts * floor_.z * floor_.z * 3.0 / (3.14159265 * radius * radius);
  for (int y = pixels.y + row; y <= pixels.w; y += step) {
    for (int x = pixels.x; x <= pixels.z; ++x) {
      int k = y * size + x;
      vec2 offset = (vec2(x, y) - middle) * scale;
      float u = 1.0 - dot(offset, offset);
      if (u <= 0.0 || (hides == 1 && depth > behind[k])) continue;
      float part = amount * u * u;
      uvec3 dyed = uvec3(part * absorbance + 0.5);
      atomicAdd(red[k], dyed.r);
      atomicAdd(green[k], dyed.g);
      atomicAdd(blue[k], dyed.b);
      if (hides == 1) {
        atomicAdd(metres[k], uint(part + 0.5));
      } else {
        // As a ball would have it, behind whose top the disc is hung: steps from disc to disc would be seen as shades.
        atomicMin(nearest[k], floatBitsToUint(max(depth + 0.5 * radius / to_sun.w * (1.0 - sqrt(u)), 0.0)));
      }
    }
  }
}

void add_list(int list, ivec2 corner, ivec2 last) {
  uint begin = tile_starts[list], count = tile_starts[list + 1] - begin;
  // Where there are few, several threads share one.
  uint team = 1u;
  while (team < 16u && 2u * team * count <= 512u) team *= 2u;
  for (uint k = gl_LocalInvocationID.x; k < team * count; k += 256u)
    add(tile_entries[begin + k / team], corner, last, int(k % team), int(team));
}

void main() {
  int k = int(gl_LocalInvocationID.x);
  ivec2 corner = ivec2(gl_WorkGroupID.xy) * size, pixel = corner + ivec2(k % size, k / size), last = imageSize(sums) - 1;
  metres[k] = red[k] = green[k] = blue[k] = 0u;
  nearest[k] = floatBitsToUint(1.0);
  behind[k] = hides == 1 ? texelFetch(solid_depth, min(2 * pixel + 1, textureSize(solid_depth, 0) - 1), 0).r : 1.0;
  barrier();
  add_list(int(gl_WorkGroupID.y) * tiles.x + int(gl_WorkGroupID.x), corner, last);
  add_list(tiles.x * tiles.y, corner, last);
  barrier();
  vec3 dyed = vec3(red[k], green[k], blue[k]) * (floor_.z / parts * most / centre.w);
  imageStore(sums, pixel, vec4(dyed, hides == 1 ? float(metres[k]) * (floor_.z / parts) : uintBitsToFloat(nearest[k])));
}
