// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// The fluid's surface from its filtered depth.
#include "fluid/fluid_depth.glsl"

vec3 surface_point(ivec2 pixel, float z) {
  return z * view_ray((vec2(pixel) + 0.5) * viewport.zw);
}

// Along the surface from this pixel, per pixel: over both sides where they go on alike, else over the side
// that lies nearer in depth, so that the edge of what is in front leaves no seam.
vec3 surface_slope(ivec2 pixel, ivec2 axis, float z, vec3 here) {
  float a = fluid_depth(pixel - axis), b = fluid_depth(pixel + axis);
  float da = a > 0.0 ? abs(z - a) : 1e30, db = b > 0.0 ? abs(b - z) : 1e30;
  vec3 back = here - surface_point(pixel - axis, a), on = surface_point(pixel + axis, b) - here;
  if (max(da, db) < 3.0 * min(da, db) + 0.05 * floor_.z) return 0.5 * (back + on);
  return da < db ? back : on;
}

// View space, towards the eye.
vec3 surface_normal(ivec2 pixel, float z) {
  vec3 here = surface_point(pixel, z);
  vec3 n = cross(surface_slope(pixel, ivec2(1, 0), z, here), surface_slope(pixel, ivec2(0, 1), z, here));
  return dot(n, n) > 0.0 ? normalize(n) : normalize(-here);
}
