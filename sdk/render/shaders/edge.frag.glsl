// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Of a solid that is drawn over the fluid, where it is before it.
#include "frame.glsl"
#include "sky.glsl"
#include "shadow.glsl"
#include "material.glsl"
#include "ground.glsl"
#include "tiling.glsl"
#include "paint.glsl"
#include "fluid_hides.glsl"
layout(location = 0) out vec4 color;

void main() {
  vec3 n;
  float gloss;
  vec3 albedo = painted(n, gloss);
  if (is_in_fluid() || is_under_ground(world, 0.0)) discard;
  color = vec4(lit(albedo, gloss, world, n), 1.0);
}
