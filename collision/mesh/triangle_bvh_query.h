// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Queries of a tree of triangles by kernels: the nearest point, and whether a point is inside.
#pragma once

#include "collision/mesh/triangle_bvh.h"
#include "collision/mesh/tuning.h"

namespace meniscus::collision {

struct ClosestPoint {
  Vec3 point;         ///< m, on the mesh
  float distance;     ///< m, not negative
  uint32_t triangle;  ///< its number in the mesh
  uint32_t slot;      ///< its place in the tree: a good first guess for a nearby point
};

// The distance of x from an interval. A comparison is one instruction everywhere, where fmaxf may be a call.
MENISCUS_HD inline float excess(float lower, float upper, float x) {
  const float below = lower - x, above = x - upper;
  const float out = below > above ? below : above;
  return out > 0 ? out : 0;
}

MENISCUS_HD inline float squared_distance_to_box(const BvhNode& node, Vec3 p) {
  return squared_length({excess(node.lower.x, node.upper.x, p.x), excess(node.lower.y, node.upper.y, p.y),
                         excess(node.lower.z, node.upper.z, p.z)});
}

/// The nearest point that a search has found so far.
struct NearestSoFar {
  Vec3 offset;    ///< m, from the point
  float squared;  ///< m², of the distance
  uint32_t slot;
};

/// Replaces `best` by the triangle that is nearest to p, if one is nearer.
MENISCUS_HD inline void find_nearer(const TriangleBvhView& bvh, Vec3 p, NearestSoFar& best) {
  uint32_t waiting[TriangleBvh::max_depth];  // at most the further child of each level
  uint32_t depth = 0, at = 0;
  while (true) {
    const BvhNode& node = bvh.nodes[at];
    for (uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Vec3 offset = offset_to_triangle(bvh.triangles[i], p);
      const float squared = squared_length(offset);
      if (squared < best.squared) best = {offset, squared, i};
    }
    if (node.count == 0) {
      const uint32_t first = at + 1, second = bvh.nodes[first].end;
      const float to_first = squared_distance_to_box(bvh.nodes[first], p);
      const float to_second = squared_distance_to_box(bvh.nodes[second], p);
      const bool in_order = to_first <= to_second;
      if ((in_order ? to_second : to_first) < best.squared) waiting[depth++] = in_order ? second : first;
      if ((in_order ? to_first : to_second) < best.squared) {
        at = in_order ? first : second;
        continue;
      }
    }
    do {
      if (depth == 0) return;
      at = waiting[--depth];
    } while (squared_distance_to_box(bvh.nodes[at], p) >= best.squared);
  }
}

/// The point of the mesh that is nearest to p. The search starts from the triangle at slot `guess`. The guess
/// affects the time and not the distance.
MENISCUS_HD inline ClosestPoint closest_point(const TriangleBvhView& bvh, Vec3 p, uint32_t guess = 0) {
  const Vec3 offset = offset_to_triangle(bvh.triangles[guess], p);
  NearestSoFar best{offset, squared_length(offset), guess};
  find_nearer(bvh, p, best);
  return {p + best.offset, sqrtf(best.squared), bvh.sources[best.slot], best.slot};
}

/// The distance from p to the mesh, or `limit` (m) if that is smaller. Far beyond the limit it is cheap.
MENISCUS_HD inline float distance_within(const TriangleBvhView& bvh, Vec3 p, float limit) {
  NearestSoFar best{{0, 0, 0}, limit * limit, 0};
  if (squared_distance_to_box(bvh.nodes[0], p) < best.squared) find_nearer(bvh, p, best);
  return best.squared < limit * limit ? sqrtf(best.squared) : limit;
}

/// The far field's first two orders (Barill et al. 2018), r from p to the centre.
MENISCUS_HD inline float far_winding(const FarField& far, Vec3 r) {
  const float rr = squared_length(r);
  const float inverse = 1.0f / rr, inverse_cube = inverse / sqrtf(rr);
  const float trace = far.diagonal.x + far.diagonal.y + far.diagonal.z;
  const float along = far.diagonal.x * r.x * r.x + far.diagonal.y * r.y * r.y + far.diagonal.z * r.z * r.z +
                      far.mixed.x * r.x * r.y + far.mixed.y * r.y * r.z + far.mixed.z * r.z * r.x;
  constexpr float inverse_4pi = 0.07957747154594767f;
  return inverse_4pi * inverse_cube * (dot(far.dipole, r) + trace - 3.0f * along * inverse);
}

/// How often the mesh winds around p: 1 inside and 0 outside of a closed mesh, smooth in between at holes
/// (Jacobson et al. 2013). Distant nodes count through their far field (Barill et al. 2018).
MENISCUS_HD inline float winding_number(const TriangleBvhView& bvh, Vec3 p) {
  using mesh_tuning::opening;
  float sum = 0;
  for (uint32_t at = 0; at < bvh.nodes.count;) {
    const FarField& far = bvh.far_fields[at];
    const BvhNode& node = bvh.nodes[at];
    const Vec3 r = far.centre - p;
    if (squared_length(r) > opening * opening * far.radius * far.radius) {
      sum += far_winding(far, r);
      at = node.end;
      continue;
    }
    for (uint32_t i = node.first; i < node.first + node.count; ++i)
      sum += covered_fraction(bvh.triangles[i], p);
    ++at;
  }
  return sum;
}

/// Tests the magnitude of the winding number, so that a mesh with inverted orientation works as well.
MENISCUS_HD inline bool is_inside(const TriangleBvhView& bvh, Vec3 p) {
  return fabsf(winding_number(bvh, p)) > 0.5f;
}

}  // namespace meniscus::collision
