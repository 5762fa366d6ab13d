// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Whether the fluid is before this fragment, or at it; or what stands in the scene, or the ground.
#include "fluid/fluid_depth.glsl"
layout(binding = 3) uniform sampler2D scene_distance;

bool is_hidden() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float fluid = fluid_depth(pixel), here = to_distance(gl_FragCoord.z);
  return here > texelFetch(scene_distance, pixel, 0).r || (fluid > 0.0 && fluid <= here);
}
