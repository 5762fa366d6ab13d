// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// The fluid's surface as the camera sees it.
#include "fluid/found.glsl"
layout(std430, binding = 8) readonly restrict buffer FluidSurface {
  float fluid_surface[];
};

bool shows_layer(ivec2 pixel) {
  return has_share(fluid_surface[place_of(pixel)]);
}

// 0 where there is none.
float fluid_depth(ivec2 pixel) {
  float found = fluid_surface[place_of(clamp(pixel, ivec2(0), ivec2(viewport.xy) - 1))];
  return is_nothing_at(found) ? 0.0 : abs(found);
}
