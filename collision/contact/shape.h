// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Shapes as kernels see them. A container is not a shape: it is up to six planes that face inwards.
#pragma once

#include <cmath>

#include "collision/contact/height_field.h"
#include "collision/mesh/surface_sample.h"
#include "collision/sdf/sdf.h"
#include "pbd/contacts.h"
#include "pbd/device/base/any.h"
#include "pbd/device/base/view.h"
#include "pbd/device/scalar.h"
#include "pbd/filter.h"
#include "pbd/math/half_space.h"

namespace meniscus::collision {

/// Surface properties of a solid towards particles.
struct Surface {
  float friction = 0;             ///< Coulomb's μ
  float restitution = 0;          ///< 0 to 1
  float adhesion = 0;             ///< N, on one particle
  float slip_length = HUGE_VALF;  ///< m, of viscous fluid
  CollisionFilter filter;
  Vec3 belt_velocity{0, 0, 0};  ///< m/s, of a fixed shape's surface along itself, in the world's frame
};

enum class ShapeKind : uint32_t { plane, box, sphere, capsule, cylinder, sdf, height_field };

MENISCUS_HD inline bool is_convex(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::plane:
    case ShapeKind::box:
    case ShapeKind::sphere:
    case ShapeKind::capsule:
    case ShapeKind::cylinder:
      return true;
    case ShapeKind::sdf:
    case ShapeKind::height_field:
      break;
  }
  return false;
}

struct Shape {
  ShapeKind kind = ShapeKind::plane;
  uint32_t owner = 0;             ///< the user's shape or body that this belongs to
  uint32_t body = pbd::no_index;  ///< the rigid body of a moving shape
  uint32_t table = 0;             ///< sdf and height_field: number of the field
  Pose pose;
  Pose start;          ///< pose at the substep's start; valid for moving shapes alone
  Vec3 size{0, 1, 0};  ///< plane: unit normal, world; box: half extents; round shapes: radius, half height, –
  float offset = 0;    ///< plane: normal · p on the surface, m
  Surface surface;
  uint32_t first_opening = 0, opening_count = 0;
  uint32_t first_wall = 0, wall_count = 0;  ///< plane: all walls of its container, if that has apertures
  Aabb bounds{{0, 0, 0},
              {0, 0, 0}};  ///< world, of the solid over the whole motion from start to pose; none for planes
};

MENISCUS_HD inline bool collide(const Shape& shape, const CollisionFilter& other) {
  return pbd::meet(shape.surface.filter, other);
}

/// A rectangle cut out of a plane. Where a point's projection lies inside `box`, in the plane's frame, the
/// plane does not act.
struct PlaneOpening {
  Aabb box;
};

/// All solids. Fixed ones come first, for all worlds of a batch. The moving ones follow, world after world.
struct ShapeSet {
  pbd::View<const Shape> shapes;
  uint32_t fixed = 0;  ///< how many are fixed
  pbd::View<const PlaneOpening> openings;
  pbd::View<const SdfView> sdfs;
  pbd::View<const HeightFieldView> height_fields;
  uint32_t worlds = 1;

  /// Moving shapes of one world.
  MENISCUS_HD uint32_t moving() const { return (shapes.count - fixed) / worlds; }
  /// Shapes of one world.
  MENISCUS_HD uint32_t of_world() const { return fixed + moving(); }
  /// The number of the shape that is the k-th of a world.
  MENISCUS_HD uint32_t number(uint32_t k, uint32_t world) const {
    return k < fixed ? k : k + world * moving();
  }
};

inline constexpr uint32_t shapes_at_once = 8;

/// Bit k is set where is_so(first + k), for up to shapes_at_once of `count` shapes. The tests are
/// independent. Tested in a plain loop, each would wait for the one before.
template <class F>
MENISCUS_HD uint32_t which_shapes(uint32_t first, uint32_t count, const F& is_so) {
  uint32_t which = 0;
  MENISCUS_UNROLL
  for (uint32_t k = 0; k < shapes_at_once; ++k) {
    if (k < count && is_so(first + k)) which |= 1u << k;
  }
  return which;
}

/// A particle's motion over a substep.
struct Motion {
  Vec3 from, to;  ///< m
};

/// The motion relative to the shape at its final pose: a straight line, whose start has moved along with the
/// shape.
MENISCUS_HD inline Motion motion_beside(const Shape& shape, const Motion& m) {
  if (shape.body == pbd::no_index) return m;
  return {to_world(shape.pose, to_local(shape.start, m.from)), m.to};
}

namespace detail {

MENISCUS_HD inline float nonzero_sign(float x) {
  return x < 0 ? -1.0f : 1.0f;
}

/// The part of the kernel between two parallel faces at ±half, for a point at coordinate x, over that of a
/// half-space.
MENISCUS_HD inline float slab_density(float x, float half, float h) {
  return pbd::half_space_density((fabsf(x) - half) / h) - pbd::half_space_density((fabsf(x) + half) / h);
}

MENISCUS_HD inline float ratio_to_half_space(float density, float distance, float h) {
  return pbd::clamp(density / pbd::max(pbd::half_space_density(distance / h), 1e-6f), 0.0f, 1.0f);
}

/// The fraction for a solid whose surface has this mean curvature in 1/m, positive where it is convex.
MENISCUS_HD inline float curved_fraction(float distance, float curvature, float h) {
  return ratio_to_half_space(pbd::half_space_density(distance / h, curvature * h), distance, h);
}

MENISCUS_HD inline SurfaceSample box_surface(Vec3 half, Vec3 q) {
  const Vec3 a = abs(q) - half;
  const Vec3 out = max(a, {0, 0, 0});
  const float outside = length(out);
  if (outside > 0) {
    return {outside,
            {out.x * nonzero_sign(q.x) / outside, out.y * nonzero_sign(q.y) / outside,
             out.z * nonzero_sign(q.z) / outside}};
  }
  if (a.x >= a.y && a.x >= a.z) return {a.x, {nonzero_sign(q.x), 0, 0}};
  if (a.y >= a.z) return {a.y, {0, nonzero_sign(q.y), 0}};
  return {a.z, {0, 0, nonzero_sign(q.z)}};
}

MENISCUS_HD inline SurfaceSample capsule_surface(float radius, float half_height, Vec3 q) {
  const Vec3 r{q.x, q.y - pbd::clamp(q.y, -half_height, half_height), q.z};
  return {length(r) - radius, normalized_or(r, {1, 0, 0})};
}

MENISCUS_HD inline SurfaceSample cylinder_surface(float radius, float half_height, Vec3 q) {
  const float rho = sqrtf(q.x * q.x + q.z * q.z);
  const Vec3 radial = normalized_or({q.x, 0, q.z}, {1, 0, 0});
  const Vec3 axial{0, nonzero_sign(q.y), 0};
  const float a = rho - radius, b = fabsf(q.y) - half_height;
  if (a > 0 && b > 0) {
    const float d = sqrtf(a * a + b * b);
    return {d, (a / d) * radial + (b / d) * axial};
  }
  return a > b ? SurfaceSample{a, radial} : SurfaceSample{b, axial};
}

/// Signed distance and normal in the shape's frame.
MENISCUS_HD inline SurfaceSample local_surface(const ShapeSet& set, const Shape& shape, Vec3 q, float reach) {
  switch (shape.kind) {
    case ShapeKind::plane:
      break;  // has no frame of its own
    case ShapeKind::box:
      return box_surface(shape.size, q);
    case ShapeKind::sphere:
      return {length(q) - shape.size.x, normalized_or(q, {0, 1, 0})};
    case ShapeKind::capsule:
      return capsule_surface(shape.size.x, shape.size.y, q);
    case ShapeKind::cylinder:
      return cylinder_surface(shape.size.x, shape.size.y, q);
    case ShapeKind::sdf:
      return sample_sdf(set.sdfs[shape.table], q);
    case ShapeKind::height_field:
      return sample_height_field(set.height_fields[shape.table], q, reach);
  }
  return {reach, {0, 1, 0}};
}

}  // namespace detail

MENISCUS_HD inline SurfaceSample plane_surface(const Shape& plane, Vec3 p) {
  return {dot(plane.size, p) - plane.offset, plane.size};
}

/// Whether two boxes are further than `reach` (m) from one another.
MENISCUS_HD inline bool are_apart(const Aabb& a, const Aabb& b, float reach) {
  return pbd::any_is_true(
      [&] { return a.lower.x > b.upper.x + reach; }, [&] { return a.lower.y > b.upper.y + reach; },
      [&] { return a.lower.z > b.upper.z + reach; }, [&] { return a.upper.x < b.lower.x - reach; },
      [&] { return a.upper.y < b.lower.y - reach; }, [&] { return a.upper.z < b.lower.z - reach; });
}

/// Whether the box of a motion is further than `reach` (m) from a solid that is not a plane.
MENISCUS_HD inline bool out_of_reach(const Shape& shape, Vec3 from, Vec3 to, float reach) {
  return are_apart({min(from, to), max(from, to)}, shape.bounds, reach);
}

/// The surface nearest to world point p. The distance must be exact up to `reach` (m).
MENISCUS_HD inline SurfaceSample sample_surface(const ShapeSet& set, const Shape& shape, Vec3 p,
                                                float reach) {
  if (shape.kind == ShapeKind::plane) return plane_surface(shape, p);
  SurfaceSample s = detail::local_surface(set, shape, to_local(shape.pose, p), reach);
  s.normal = rotate(shape.pose.rotation, s.normal);
  return s;
}

/// How the solid differs from a half-space behind the surface at `distance` (m) from p. It is the part of the
/// kernel of support radius h (m) that the solid fills, over that of the half-space. Faces that meet at an
/// edge fill the product of their fractions, which is exact on a face and on an edge of a box.
MENISCUS_HD inline float solid_fraction(const ShapeSet& set, const Shape& shape, Vec3 p, float distance,
                                        float h) {
  using namespace detail;
  const Vec3 q = to_local(shape.pose, p);
  switch (shape.kind) {
    case ShapeKind::plane:
    case ShapeKind::height_field:
      break;
    case ShapeKind::box:
      return ratio_to_half_space(slab_density(q.x, shape.size.x, h) * slab_density(q.y, shape.size.y, h) *
                                     slab_density(q.z, shape.size.z, h),
                                 distance, h);
    case ShapeKind::cylinder: {
      const float rho = sqrtf(q.x * q.x + q.z * q.z);
      const float round = pbd::half_space_density((rho - shape.size.x) / h, 0.5f * h / shape.size.x);
      return ratio_to_half_space(round * slab_density(q.y, shape.size.y, h), distance, h);
    }
    case ShapeKind::sdf:
      return ratio_to_half_space(sample_density(set.sdfs[shape.table], q).density, distance, h);
    case ShapeKind::sphere:
      return curved_fraction(distance, 1 / shape.size.x, h);
    case ShapeKind::capsule:
      return curved_fraction(distance, (fabsf(q.y) > shape.size.y ? 1.0f : 0.5f) / shape.size.x, h);
  }
  return 1;
}

/// Whether the plane does not act at p because the projection of p lies in an aperture.
MENISCUS_HD inline bool in_opening(const ShapeSet& set, const Shape& plane, Vec3 p) {
  const Vec3 q = to_local(plane.pose, p);
  for (uint32_t k = plane.first_opening; k < plane.first_opening + plane.opening_count; ++k) {
    const Aabb& b = set.openings[k].box;
    if (q.x >= b.lower.x && q.x <= b.upper.x && q.y >= b.lower.y && q.y <= b.upper.y && q.z >= b.lower.z &&
        q.z <= b.upper.z) {
      return true;
    }
  }
  return false;
}

}  // namespace meniscus::collision
