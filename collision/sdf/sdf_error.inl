// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels and functions that measure the error of a distance field.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/mesh/triangle_bvh_query.h"
#include "collision/sdf/sdf_error.h"
#include "collision/sdf/sdf_error_points.h"
#include "collision/sdf/tuning.h"

namespace meniscus::collision {

namespace sdf_error_kernels {

struct OnSurface {
  SdfView field;
  pbd::View<const Vec3> points;
  pbd::View<float> errors;

  MENISCUS_HD void operator()(uint32_t i) const { errors[i] = fabsf(sample_sdf(field, points[i]).distance); }
};

struct NearSurface {
  SdfView field;
  TriangleBvhView mesh;
  pbd::View<const Vec3> points;
  pbd::View<float> errors;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 p = points[i];
    const float winding = fabsf(winding_number(mesh, p)), distance = closest_point(mesh, p).distance;
    const bool beside_hole =
        winding > sdf_tuning::least_beside_hole && winding < sdf_tuning::most_beside_hole;
    const float exact = winding > 0.5f ? -distance : distance;
    errors[i] =
        beside_hole || !(clamp_to_grid(field, p) == p) ? 0 : fabsf(sample_sdf(field, p).distance - exact);
  }
};

}  // namespace sdf_error_kernels

template <class D>
float sdf_error(D& device, const TriangleMesh& mesh, const DeviceTriangleBvh& tree, const Sdf& field) {
  using namespace sdf_error_kernels;
  const std::vector<Vec3> on = points_on_surface(mesh);
  const std::vector<Vec3> near = points_near_surface(mesh, sdf_tuning::strewn_points, field.nodes().spacing);
  const auto on_count = static_cast<uint32_t>(on.size()), near_count = static_cast<uint32_t>(near.size());
  pbd::Buffer<Vec3> on_points(device, "points on a mesh"), near_points(device, "points near a mesh");
  pbd::Buffer<float> on_errors(device, "errors on a mesh"), near_errors(device, "errors near a mesh");
  on_points.resize_discard(on_count);
  near_points.resize_discard(near_count);
  on_errors.resize_discard(on_count);
  near_errors.resize_discard(near_count);
  on_points.write(on);
  near_points.write(near);
  device.parallel_for("errors on a mesh", on_count,
                      OnSurface{field.view(), on_points.view(), on_errors.view()});
  device.parallel_for("errors near a mesh", near_count,
                      NearSurface{field.view(), tree.view(), near_points.view(), near_errors.view()});
  const std::vector<float> a = on_errors.read(on_count), b = near_errors.read(near_count);
  return std::max(*std::max_element(a.begin(), a.end()), *std::max_element(b.begin(), b.end()));
}

template <class D>
Sdf build_sdf_to_error(D& device, const TriangleMesh& mesh, const DeviceTriangleBvh& tree, float target_error,
                       float margin, uint32_t max_points) {
  check_error_target(target_error, margin);
  const Aabb box = tree.bounds();
  float cell_size = max_component(box.upper - box.lower) / sdf_tuning::first_cells,
        error = std::numeric_limits<float>::infinity();
  double points = lattice_points_around(box, cell_size, margin);
  while (points <= max_points) {
    Sdf field = build_sdf(device, tree, cell_size, margin);
    error = sdf_error(device, mesh, tree, field);
    if (error <= target_error) return field;
    cell_size *= 0.5f;
    points = lattice_points_around(box, cell_size, margin);
  }
  refuse_error_target(target_error, error, cell_size, points, max_points);
}

}  // namespace meniscus::collision
