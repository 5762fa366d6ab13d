// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
#include "frame.glsl"
#include "tiling.glsl"
#include "paint.glsl"
#include "surfaces.glsl"

void main() {
  vec3 n;
  float gloss;
  vec3 albedo = painted(n, gloss);
  put(albedo, gloss, n);
}
