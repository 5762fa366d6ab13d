// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Signed distance fields and density maps, as kernels read them.
#pragma once

#include "collision/mesh/surface_sample.h"
#include "collision/sdf/grid_view.h"

namespace meniscus::collision {

/// Signed distances to a solid, m, negative inside. The solid lies within the grid's box.
struct SdfView : GridView {
  pbd::View<const pbd::Vec4> density;  ///< the density map (density_map.h): ∇B in xyz, 1/m, B in w; or empty
};

/// Signed distance at a point of the field's frame; the normal is the field's gradient.
/// Beyond the grid the distance is √(d² + e²). d is the distance at the nearest point of the grid, and e the
/// distance to that point. The grid's box is convex and contains the solid, so no point of the solid is
/// nearer. The extension is continuous and never too large.
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

/// The fraction of a particle's kernel that the solid fills.
struct DensitySample {
  float density;  ///< B = ∫ W over the solid, 0 to 1
  Vec3 gradient;  ///< ∇B, 1/m, into the solid
};

/// Samples the density map, which must exist. The gradient is trilinear. B blends linear extrapolations from
/// the cell's nodes, each with half of the node's gradient. This is exact where B is of second order, and
/// needs no more loads than the values alone. Beyond the grid the density is 0.
MENISCUS_HD inline DensitySample sample_density(const SdfView& sdf, Vec3 p) {
  const Lattice& n = sdf.nodes;
  if (!(clamp_to_grid(sdf, p) == p)) return {0, {0, 0, 0}};
  const Vec3 u = (p - n.origin) / n.spacing;
  const GridPlace x = place_in_grid(u.x, n.nx), y = place_in_grid(u.y, n.ny), z = place_in_grid(u.z, n.nz);
  float density = 0;
  Vec3 gradient{0, 0, 0};
  for (uint32_t corner = 0; corner < 8; ++corner) {
    const uint32_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
    const Vec3 displacement = Vec3{x.fraction, y.fraction, z.fraction} -
                              Vec3{static_cast<float>(i), static_cast<float>(j), static_cast<float>(k)};
    const float weight =
        (1 - fabsf(displacement.x)) * (1 - fabsf(displacement.y)) * (1 - fabsf(displacement.z));
    const pbd::Vec4 node = pbd::load(sdf.density, n.index(x.cell + i, y.cell + j, z.cell + k));
    density += weight * (node.w + 0.5f * n.spacing * dot(node.xyz(), displacement));
    gradient += weight * node.xyz();
  }
  return {clamped(density, 0, 1), gradient};
}

}  // namespace meniscus::collision
