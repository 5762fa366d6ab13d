// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds which shapes need images across the seams of periodic axes, and refuses those that cannot have any.
#include "sdk/world/solids/seam_images.h"

#include <meniscus/error.h>

#include <cmath>
#include <cstdint>

namespace meniscus {

namespace {

using collision::Shape;
using collision::ShapeKind;

constexpr char axis_names[] = "xyz";

float along(Vec3 v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

[[noreturn]] void refuse_shape(const std::string& name, const std::string& why) {
  throw Error(ErrorCode::invalid_argument,
              "the shape \"" + name + "\" does not fit the periodic axes: " + why);
}

/// How much of a unit vector is off an axis that it should be parallel or normal to.
constexpr float crooked = 1e-6f;

bool is_parallel(Vec3 unit, int axis) {
  return std::fabs(along(unit, axis)) > 1 - crooked;
}

/// Whether the cross-section of a shape does not change along the axis, apart from its ends.
bool is_prism(const Shape& shape, int axis) {
  const auto own = [&](Vec3 v) { return is_parallel(rotate(shape.pose.rotation, v), axis); };
  if (shape.kind == ShapeKind::cylinder) return own({0, 1, 0});
  if (shape.kind == ShapeKind::box) return own({1, 0, 0}) || own({0, 1, 0}) || own({0, 0, 1});
  return false;
}

/// Whether images have to stand for this shape across the seams of an axis; throws if they cannot.
bool has_images(const Shape& shape, const pbd::PeriodicAxes& axes, int axis, float reach,
                const std::string& name) {
  const float low = along(axes.low, axis), extent = along(axes.extent, axis);
  if (!(extent > 0)) return false;
  const std::string on_axis = std::string(" along ") + axis_names[axis];
  if (shape.kind == ShapeKind::plane) {
    if (shape.opening_count > 0) refuse_shape(name, "its openings must be whole faces");
    if (std::fabs(along(shape.size, axis)) > crooked)
      refuse_shape(name, "a plane must not face" + on_axis + ", nor a face of a container");
    return false;
  }
  const float from = along(shape.bounds.lower, axis), to = along(shape.bounds.upper, axis);
  if (from > low + extent || to < low) refuse_shape(name, "it is beyond the ends" + on_axis);
  if (from >= low + reach && to <= low + extent - reach) return false;
  if (from <= low - reach && to >= low + extent + reach && is_prism(shape, axis)) return false;
  if (to - from > extent - 2 * reach)
    refuse_shape(name, "it must be shorter than the extent" + on_axis +
                           " less 2 support radii, or a box or cylinder" + on_axis +
                           " that reaches a support radius beyond both ends");
  return true;
}

}  // namespace

std::vector<Shape> with_seam_images(const Shape& shape, const pbd::PeriodicAxes& axes, float reach,
                                    const std::string& name) {
  const auto across = [&](int axis) {
    if (!has_images(shape, axes, axis, reach, name)) return 0.0f;
    const float extent = along(axes.extent, axis);
    return along(shape.bounds.lower, axis) < along(axes.low, axis) + reach ? extent : -extent;
  };
  const pbd::SeamImages images{{across(0), across(1), across(2)}};
  std::vector<Shape> all{shape};
  for (uint32_t n = 0; n < images.count(); ++n) {
    Shape image = shape;
    const Vec3 offset = images.offset(n);
    image.pose.position += offset;
    image.bounds = {image.bounds.lower + offset, image.bounds.upper + offset};
    all.push_back(image);
  }
  return all;
}

std::vector<Vec3> with_seam_images(std::span<const Vec3> points, const pbd::PeriodicAxes& axes, float reach) {
  std::vector<Vec3> all(points.begin(), points.end());
  for (const Vec3 p : points) {
    const pbd::SeamImages images{axes.across_seams(p, reach)};
    for (uint32_t n = 0; n < images.count(); ++n) all.push_back(p + images.offset(n));
  }
  return all;
}

}  // namespace meniscus
