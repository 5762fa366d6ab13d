// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// The surface of the fluid behind the front layer; see fluid/fluid_depth.glsl.
layout(std430, binding = 10) readonly restrict buffer RestSurface {
  float rest_surface[];
};

// 0 where there is none.
float rest_depth(ivec2 pixel) {
  float found = rest_surface[place_of(clamp(pixel, ivec2(0), ivec2(viewport.xy) - 1))];
  return has_share(found) ? abs(found) : 0.0;
}
