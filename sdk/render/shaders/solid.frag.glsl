// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
#include "frame.glsl"
#include "ground.glsl"
#include "tiling.glsl"
#include "paint.glsl"
#include "surfaces.glsl"

void main() {
  vec3 n;
  float gloss;
  vec3 albedo = painted(n, gloss);
  if (is_under_ground(world, 1e-5 * floor_.y)) discard;
  put(albedo, gloss, n);
}
