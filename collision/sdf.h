// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/grid.h"
#include "collision/surface_sample.h"

namespace meniscus::collision {

/// Signed distances to a solid, m, negative inside. The solid lies within the grid's box.
using SdfView = GridView;

/// Signed distance at a point of the field's frame; the normal is the field's gradient.
/// Beyond the grid the distance is √(d² + e²), with d that at the nearest point of the grid and e the
/// distance to it. As the grid's box is convex and holds the solid, no point of the solid is nearer: the
/// extension is continuous and never says too much.
MENISCUS_HD inline SurfaceSample sample_sdf(const SdfView& sdf, Vec3 p) {
  const Vec3 up{0, 1, 0};
  const Vec3 clamped_point = clamp_to_grid(sdf, p);
  const Vec3 gap = p - clamped_point;
  const GridSample sample = sample_grid(sdf, clamped_point);
  const float gap2 = dot(gap, gap);
  if (gap2 == 0) return {sample.value, normalized_or(sample.gradient, up)};
  const float distance = sqrtf(sample.value * sample.value + gap2);
  return {distance, normalized_or(gap + sample.value * sample.gradient, up)};
}

}  // namespace meniscus::collision
