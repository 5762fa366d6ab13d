// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// What the filters of the fluid's depth share. Depths are distances along −z; 0 is where there is no fluid. Beside
// them stands how far the filter reaches, as a share.
layout(binding = 4) uniform sampler2D fluid_depth;
layout(binding = 0, rg32f) writeonly restrict uniform image2D result_depth;
layout(location = 0) uniform ivec2 axis;       // pixels, from one to the next along the filter
layout(location = 1) uniform float reach;      // m, one standard deviation
layout(location = 2) uniform float threshold;  // m: what is further apart in depth is another surface

vec2 surface_at(ivec2 pixel) {
  return texelFetch(fluid_depth, clamp(pixel, ivec2(0), textureSize(fluid_depth, 0) - 1), 0).rg;
}
