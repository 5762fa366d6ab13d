// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/engine/engine.inl"

namespace meniscus {

template <class D>
uint32_t DeviceEngine<D>::add_sdf(const collision::TriangleMesh& mesh, float cell_size, float margin) {
  sdf_grids_.push_back(collision::build_sdf(
      device_, collision::DeviceTriangleBvh(device_, collision::TriangleBvh(mesh)), cell_size, margin));
  sdf_views_.push_back(sdf_grids_.back().view());
  replace<collision::SdfView>(sdfs_, sdf_views_);
  return static_cast<uint32_t>(sdf_views_.size() - 1);
}

template <class D>
uint32_t DeviceEngine<D>::add_height_field(uint32_t columns, uint32_t rows, float cell_size,
                                           std::span<const float> heights) {
  pbd::Buffer<float>& samples = height_samples_.emplace_back(device_, "height samples");
  replace(samples, heights);
  height_views_.push_back({columns, rows, cell_size, samples.view()});
  replace<collision::HeightFieldView>(height_fields_, height_views_);
  return static_cast<uint32_t>(height_views_.size() - 1);
}

template <class D>
void DeviceEngine<D>::set_shapes(std::span<const collision::Shape> shapes,
                                 std::span<const collision::PlaneOpening> openings) {
  replace(shapes_, shapes);
  replace(openings_, openings);
  shape_set_ = {shapes_.view(), openings_.view(), sdfs_.view(), height_fields_.view()};
  contacts_.set_shapes(shape_set_);
}

template <class D>
std::vector<Vec3> DeviceEngine<D>::fill_mesh(const collision::TriangleMesh& mesh, float spacing) {
  return collision::lattice_points_inside(
      device_, collision::DeviceTriangleBvh(device_, collision::TriangleBvh(mesh)), spacing);
}

template <class D>
std::vector<float> DeviceEngine<D>::solid_distances(std::span<const Vec3> points, float reach) {
  const auto count = static_cast<uint32_t>(points.size());
  pbd::Buffer<Vec3> in(device_, "points");
  pbd::Buffer<float> out(device_, "distances");
  replace(in, points);
  out.resize_discard(count);
  device_.parallel_for("shapes/distance", count,
                       engine_kernels::SolidDistance{shape_set_, in.view(), out.view(), reach});
  return out.read(count);
}

}  // namespace meniscus
