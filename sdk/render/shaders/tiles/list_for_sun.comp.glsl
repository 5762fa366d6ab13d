// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
#include "shared/frame.glsl"
#include "particles/fluids.glsl"
#include "particles/particles.glsl"
#include "particles/disc.glsl"
#include "tiles/tiles.glsl"
layout(location = 1) uniform ivec2 tiles;   // along x and y: all of the picture
layout(location = 3) uniform float radius;  // m, of the disc

const int tile_size = 16;

// In any order: few threads at a time want the same counter.
ivec4 pixels_covered(uint i, out uint strand) {
  strand = i % strands;
  vec3 centre_ = centre_of(i);
  if (is_grain(fluid_indices[i]) || !is_finite(centre_)) return ivec4(0, 0, -1, -1);
  return disc_pixels(world_to_sun * vec4(centre_, 1.0), vec2(radius / to_sun.w), tile_size * tiles);
}

#include "tiles/list.glsl"
