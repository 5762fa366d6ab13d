// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
#include "shared/frame.glsl"
#include "particles/fluids.glsl"
#include "particles/quadric.glsl"
#include "particles/particles.glsl"
#include "particles/ellipsoid.glsl"
#include "particles/disc.glsl"
#include "tiles/tiles.glsl"
layout(location = 1) uniform ivec2 tiles;   // along x and y
layout(location = 3) uniform float radius;  // m, of the disc

const int tile_size = 32;

// Of equally deep slices of the scene; the nearest comes first.
uint strand_at(float distance) {
  float middle = -(view * vec4(centre.xyz, 1.0)).z, radius = floor_.y;
  return uint(clamp((0.5 + 0.5 * (distance - middle) / radius) * float(strands), 0.0, float(strands) - 0.5));
}

// Its ellipsoid, and its disc among the sums of half as many pixels.
ivec4 pixels_covered(uint i, out uint strand) {
  Particle p = particle(i);
  strand = 0u;
  if (is_grain(fluid_indices[i]) || !is_finite(p.centre) || !is_finite(p.radii)) return ivec4(0, 0, -1, -1);
  vec3 middle = (view * vec4(p.centre, 1.0)).xyz;
  strand = strand_at(-middle.z);
  ivec4 ellipsoid = pixels_of(axes_of(p, turn_of(p.rotation)), longest(p.radii), middle);
  ivec4 disc = disc_pixels(projection * vec4(middle, 1.0), radius * vec2(projection[0][0], projection[1][1]),
                           ivec2(viewport.xy + 1.0) / 2);
  if (disc.x > disc.z || disc.y > disc.w) return ellipsoid;
  disc = ivec4(2 * disc.xy, min(2 * disc.zw + 1, ivec2(viewport.xy) - 1));
  if (ellipsoid.x > ellipsoid.z || ellipsoid.y > ellipsoid.w) return disc;
  return ivec4(min(ellipsoid.xy, disc.xy), max(ellipsoid.zw, disc.zw));
}

#include "tiles/list.glsl"
