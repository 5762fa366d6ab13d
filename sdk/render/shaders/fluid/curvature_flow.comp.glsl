// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// One step of curvature flow (van der Laan, Green & Sainz 2009, eqs. 3 to 9), as long as is stable.
#include "shared/frame.glsl"
#include "fluid/filter.glsl"

// What lies across an edge is taken to be level with this pixel.
float level(float z, float here) {
  return z > 0.0 && abs(z - here) < threshold ? z : here;
}

float filtered(ivec2 pixel, float found) {
  float z = abs(found);
  float l = level(fluid_depth(pixel - ivec2(1, 0)), z), r = level(fluid_depth(pixel + ivec2(1, 0)), z);
  float d = level(fluid_depth(pixel - ivec2(0, 1)), z), u = level(fluid_depth(pixel + ivec2(0, 1)), z);
  float ld = level(fluid_depth(pixel - 1), z), ru = level(fluid_depth(pixel + 1), z);
  float lu = level(fluid_depth(pixel + ivec2(-1, 1)), z), rd = level(fluid_depth(pixel + ivec2(1, -1)), z);
  float zx = 0.5 * (r - l), zy = 0.5 * (u - d), zxx = r - 2.0 * z + l, zyy = u - 2.0 * z + d;
  float zxy = 0.25 * (ru - rd - lu + ld);
  float cx = 2.0 * lens.x * viewport.z, cy = 2.0 * lens.y * viewport.w;
  float D = cy * cy * zx * zx + cx * cx * zy * zy + cx * cx * cy * cy * z * z;
  float Dx = 2.0 * (cy * cy * zx * zxx + cx * cx * zy * zxy + cx * cx * cy * cy * z * zx);
  float Dy = 2.0 * (cy * cy * zx * zxy + cx * cx * zy * zyy + cx * cx * cy * cy * z * zy);
  float Ex = zxx * D - 0.5 * zx * Dx, Ey = zyy * D - 0.5 * zy * Dy;
  return z + share_of(found) * 0.2 * cx * z * (cy * Ex + cx * Ey) / pow(D, 1.5);
}
