// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Normals in view space, for those who measure them; 0 where there is no fluid.
#include "shared/frame.glsl"
#include "fluid/surface.glsl"
layout(location = 0) out vec4 result;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float z = fluid_depth(pixel);
  result = z > 0.0 ? vec4(surface_normal(pixel, z), z) : vec4(0.0);
}
