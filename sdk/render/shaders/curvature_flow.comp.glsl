// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// One step of curvature flow (van der Laan, Green & Sainz 2009, eqs. 3 to 9), as long as is stable.
#include "frame.glsl"
#include "pixels.glsl"
#include "filter.glsl"

// What lies across an edge is taken to be level with this pixel.
float level(float z, float here) {
  return z > 0.0 && abs(z - here) < threshold ? z : here;
}

vec2 filtered(ivec2 pixel) {
  vec2 result = texelFetch(fluid_depth, pixel, 0).rg;
  float z = result.r;
  if (z <= 0.0) return result;
  float l = level(depth_at(pixel - ivec2(1, 0)), z), r = level(depth_at(pixel + ivec2(1, 0)), z);
  float d = level(depth_at(pixel - ivec2(0, 1)), z), u = level(depth_at(pixel + ivec2(0, 1)), z);
  float ld = level(depth_at(pixel - 1), z), ru = level(depth_at(pixel + 1), z);
  float lu = level(depth_at(pixel + ivec2(-1, 1)), z), rd = level(depth_at(pixel + ivec2(1, -1)), z);
  float zx = 0.5 * (r - l), zy = 0.5 * (u - d), zxx = r - 2.0 * z + l, zyy = u - 2.0 * z + d;
  float zxy = 0.25 * (ru - rd - lu + ld);
  float cx = 2.0 * lens.x * viewport.z, cy = 2.0 * lens.y * viewport.w;
  float D = cy * cy * zx * zx + cx * cx * zy * zy + cx * cx * cy * cy * z * z;
  float Dx = 2.0 * (cy * cy * zx * zxx + cx * cx * zy * zxy + cx * cx * cy * cy * z * zx);
  float Dy = 2.0 * (cy * cy * zx * zxy + cx * cx * zy * zyy + cx * cx * cy * cy * z * zy);
  float Ex = zxx * D - 0.5 * zx * Dx, Ey = zyy * D - 0.5 * zy * Dy;
  result.r = z + result.g * 0.2 * cx * z * (cy * Ex + cx * Ey) / pow(D, 1.5);
  return result;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (!is_outside(pixel)) imageStore(result_depth, pixel, vec4(filtered(pixel), 0.0, 0.0));
}
