// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a particle does to a mesh finer than the particles are: vertices between those of the triangles that
// are touched would else go unloaded.
#pragma once

#include "collision/sheet_area.h"
#include "collision/sheet_surface.h"

namespace meniscus::collision::sheet_kernels {

/// Shares a touch among the vertices within `radius` of its point. The weights are a kernel's, corrected so
/// that they give back the point itself as well as a constant (moving least squares): then forces across the
/// sheet turn nothing. False where the vertices are too few, or to one side.
MENISCUS_HD inline bool spread_within(const Surface& surface, float radius, SheetTouch& touch) {
  const Tangents axes(touch.normal);
  float one = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
  float at_u[SheetTouch::most_vertices], at_v[SheetTouch::most_vertices];
  touch.vertices = 0;
  const auto visit = [&](uint32_t vertex) {
    for (uint32_t k = 0; k < touch.vertices; ++k)
      if (touch.vertex[k] == vertex) return;
    const Vec3 d = surface.end(vertex) - touch.point;
    const float left = 1 - dot(d, d) / (radius * radius);
    if (left <= 0 || touch.vertices == SheetTouch::most_vertices) return;
    const float w = left * left, x = dot(d, axes.u) / radius, y = dot(d, axes.v) / radius;
    at_u[touch.vertices] = x;
    at_v[touch.vertices] = y;
    touch.add(vertex, w);
    one += w, u += w * x, v += w * y, uu += w * x * x, uv += w * x * y, vv += w * y * y;
  };
  const Vec3 reach{radius, radius, radius};
  pbd::for_each_overlap(surface.tree, {touch.point - reach, touch.point + reach}, 0, 0, [&](uint32_t n) {
    const pbd::SurfaceTriangle t = load(surface.tree.triangles, n);
    if (t.part != touch.part) return;
    visit(t.a);
    visit(t.b);
    visit(t.c);
  });
  // The first row of the inverse of the moments.
  const float a = uu * vv - uv * uv, b = uv * v - u * vv, c = u * uv - uu * v;
  const float determinant = one * a + u * b + v * c;
  bool good = touch.vertices >= 4 && determinant > 1e-4f * one * one * one;
  for (uint32_t k = 0; k < touch.vertices && good; ++k) {
    touch.weight[k] *= (a + b * at_u[k] + c * at_v[k]) / determinant;
    good = touch.weight[k] >= 0;
  }
  if (!good) touch.vertices = 0;
  return good;
}

/// The same, as far as a border allows; false where it does not.
MENISCUS_HD inline bool spread_out(const Surface& surface, float radius, SheetTouch& touch) {
  for (float r = radius; r > 0.4f * radius; r *= 0.75f)
    if (spread_within(surface, r, touch)) return true;
  return false;
}

}  // namespace meniscus::collision::sheet_kernels
