// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ground given by heights over a regular grid. At the border of the grid the ground ends in a vertical cliff.
// A point beyond the border is outside, whatever its height. If it is above the ground, it sees the surface
// and its edge. If it is lower than the edge, it sees the cliff. A point under the ground sees the surface
// alone, so that it is pushed up and not sideways.
#pragma once

#include "collision/mesh/surface_sample.h"
#include "collision/mesh/triangle.h"
#include "pbd/device/base/view.h"

namespace meniscus::collision {

struct HeightFieldView {
  uint32_t columns, rows;          ///< samples along x and z, at least 2
  float cell_size;                 ///< m
  pbd::View<const float> heights;  ///< m, x fastest; the origin is the middle of the field

  MENISCUS_HD Vec3 half_extent() const {
    return 0.5f * cell_size * Vec3{static_cast<float>(columns - 1), 0, static_cast<float>(rows - 1)};
  }
  MENISCUS_HD Vec3 vertex(uint32_t i, uint32_t j) const {
    return Vec3{cell_size * static_cast<float>(i), heights[j * columns + i],
                cell_size * static_cast<float>(j)} -
           half_extent();
  }
};

/// One of the two triangles of cell (i, j). They meet on the diagonal from (i + 1, j) to (i, j + 1), as in
/// Bullet.
MENISCUS_HD inline Triangle height_field_triangle(const HeightFieldView& field, uint32_t i, uint32_t j,
                                                  bool second) {
  const Vec3 b = field.vertex(i, j + 1), c = field.vertex(i + 1, j);
  return second ? Triangle{c, b, field.vertex(i + 1, j + 1)} : Triangle{field.vertex(i, j), b, c};
}

/// The cell along one axis that contains a coordinate, or the nearest cell; x counts from the field's border.
MENISCUS_HD inline uint32_t height_field_cell(float x, float cell_size, uint32_t samples) {
  const float u = x / cell_size, last = static_cast<float>(samples - 2);
  return static_cast<uint32_t>(u > 0 ? (u < last ? u : last) : 0.0f);  // 0 for NaN
}

/// Height of the surface at (p.x, p.z), which must be on the field.
MENISCUS_HD inline float height_at(const HeightFieldView& field, Vec3 p) {
  const Vec3 q = p + field.half_extent();
  const uint32_t i = height_field_cell(q.x, field.cell_size, field.columns);
  const uint32_t j = height_field_cell(q.z, field.cell_size, field.rows);
  const float u = q.x / field.cell_size - static_cast<float>(i),
              v = q.z / field.cell_size - static_cast<float>(j);
  const bool second = u + v > 1;
  const float corner = field.vertex(second ? i + 1 : i, second ? j + 1 : j).y;
  const float beside_x = field.vertex(second ? i : i + 1, second ? j + 1 : j).y;
  const float beside_z = field.vertex(second ? i + 1 : i, second ? j : j + 1).y;
  return corner + (second ? 1 - u : u) * (beside_x - corner) + (second ? 1 - v : v) * (beside_z - corner);
}

struct HeightFieldNearest {
  Vec3 offset;        ///< m, from the point to the surface
  Vec3 normal;        ///< of the triangle there, up; not of unit length
  float distance_sq;  ///< m²
};

MENISCUS_HD inline void keep_nearer(HeightFieldNearest& best, const Triangle& t, Vec3 p) {
  const Vec3 offset = offset_to_triangle(t, p);
  const float distance_sq = squared_length(offset);
  if (distance_sq < best.distance_sq) best = {offset, area_normal(t), distance_sq};
}

/// The nearest point of the surface, among the cells within `reach` of p in x and z.
MENISCUS_HD inline HeightFieldNearest nearest_on_height_field(const HeightFieldView& field, Vec3 p,
                                                              float reach) {
  const Vec3 q = p + field.half_extent();
  const float h = field.cell_size;
  const uint32_t i_end = height_field_cell(q.x + reach, h, field.columns);
  const uint32_t j_end = height_field_cell(q.z + reach, h, field.rows);
  HeightFieldNearest best{{0, 0, 0}, {0, 1, 0}, 3e38f};
  for (uint32_t j = height_field_cell(q.z - reach, h, field.rows); j <= j_end; ++j) {
    for (uint32_t i = height_field_cell(q.x - reach, h, field.columns); i <= i_end; ++i) {
      keep_nearer(best, height_field_triangle(field, i, j, false), p);
      keep_nearer(best, height_field_triangle(field, i, j, true), p);
    }
  }
  return best;
}

/// Signed distance and normal, exact within `reach` (m) of the surface; further away the distance is ±reach,
/// and the normal points up.
MENISCUS_HD inline SurfaceSample sample_height_field(const HeightFieldView& field, Vec3 p, float reach) {
  const Vec3 half = field.half_extent(), up{0, 1, 0};
  const Vec3 over{p.x > half.x ? half.x : (p.x < -half.x ? -half.x : p.x), p.y,
                  p.z > half.z ? half.z : (p.z < -half.z ? -half.z : p.z)};
  const Vec3 gap = p - over;
  const bool beyond = squared_length(gap) > 0;
  const float above = p.y - height_at(field, over);
  if (beyond && !(above > 0)) return {length(gap), normalized_or(gap, up)};

  // On the field, the surface straight above or below gives an upper bound, which may spare most of the
  // cells.
  const float search = !beyond && fabsf(above) < reach ? fabsf(above) : reach;
  const HeightFieldNearest nearest = nearest_on_height_field(field, p, search);
  const float side = above < 0 ? -1.0f : 1.0f;
  const float distance = sqrtf(nearest.distance_sq);
  if (distance > reach) return {side * reach, up};
  // So near the surface, the offset is only rounding: the triangle's normal tells the outside.
  const bool touching = distance < 1e-4f * field.cell_size;
  return {side * distance, normalized_or(touching ? nearest.normal : -side * nearest.offset, up)};
}

}  // namespace meniscus::collision
