// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// DeviceEngine's calls about solids and their distance fields.
#pragma once

#include <limits>

#include "sdk/engine/engine.inl"

namespace meniscus {

/// The first free place of a table; the table grows by one if there is none.
template <class T>
uint32_t free_place(std::vector<std::optional<T>>& table) {
  const auto at = std::find_if(table.begin(), table.end(), [](const auto& entry) { return !entry; });
  const auto place = static_cast<uint32_t>(at - table.begin());
  if (at == table.end()) table.emplace_back();
  return place;
}

/// By number of the fixed shape, or of the body.
inline std::vector<float> slip_lengths(std::span<const collision::Shape> shapes, bool of_bodies) {
  std::vector<float> slip;
  for (const collision::Shape& shape : shapes) {
    if ((shape.body != pbd::no_index) != of_bodies) continue;
    if (shape.owner >= slip.size()) slip.resize(shape.owner + 1, std::numeric_limits<float>::infinity());
    slip[shape.owner] = shape.surface.slip_length;
  }
  return slip;
}

template <class D>
uint32_t DeviceEngine<D>::add_sdf(const collision::TriangleMesh& mesh, float cell_size, float max_error,
                                  float margin) {
  // It reaches the device with the shapes. Until then the device's table, which kernels read, stays as it is.
  return mesh_fields_.acquire(device_, mesh, cell_size, max_error, margin, def_.solver.support_radius);
}

template <class D>
uint32_t DeviceEngine<D>::add_height_field(uint32_t columns, uint32_t rows, float cell_size,
                                           std::span<const float> heights) {
  pbd::Buffer<float> samples(device_, "height samples");
  replace(samples, heights);
  const uint32_t place = free_place(height_samples_);
  height_views_.resize(height_samples_.size());
  height_views_[place] = {columns, rows, cell_size,
                          height_samples_[place].emplace(std::move(samples)).view()};
  return place;
}

template <class D>
void DeviceEngine<D>::set_shapes(const SolidShapes& solids) {
  replace<collision::SdfView>(sdfs_, mesh_fields_.views());
  replace<collision::HeightFieldView>(height_fields_, height_views_);
  replace<collision::Shape>(shapes_, solids.shapes);
  replace<collision::PlaneOpening>(openings_, solids.openings);
  shape_set_ = {shapes_.view(), solids.fixed,          openings_.view(),
                sdfs_.view(),   height_fields_.view(), solids.worlds};
  const bool fixed_are_planes =
      std::all_of(solids.shapes.begin(), solids.shapes.begin() + solids.fixed,
                  [](const collision::Shape& s) { return s.kind == collision::ShapeKind::plane; });
  contacts_.set_shapes(shape_set_, fixed_are_planes);
  bodies_.set_shapes(solids.carried, shapes_.view());
  viscosity_.set_walls(slip_lengths(solids.shapes, false), slip_lengths(solids.shapes, true));
  films_.set_parts(solids.films, bodies_.worlds().body_slots(), solids.shapes, solids.fixed, solids.worlds);
  any_overlapping_ = true;
}

template <class D>
void DeviceEngine<D>::place_bodies() {
  bodies_.place();
  any_overlapping_ = true;
}

/// Marks particles and vertices that overlap solids after solids, cloth or particles were placed.
template <class D>
void DeviceEngine<D>::note_overlapping() {
  if (!any_overlapping_ || shape_set_.shapes.count == 0) return;
  note_overlapping({});
  any_overlapping_ = false;
}

/// The same in these worlds of a batch.
template <class D>
void DeviceEngine<D>::note_overlapping(pbd::View<const uint32_t> chosen_worlds) {
  const pbd::View<const pbd::Vec4> position = particles_.position.current.view();
  device_.parallel_for("shapes/placed", particles_.count(),
                       engine_kernels::NotePlaced{
                           shape_set_,
                           contacts_.find_near(position, particles_.count(), contacts_.largest_radius()),
                           contacts_.touches(particles_.phase.current.view(), particles_.sorted()),
                           position,
                           particles_.phase.current.view(),
                           {chosen_worlds, particles_.sorted() / solver_.worlds(), particles_.sorted()},
                           {chosen_worlds, solver_.vertices_of_world(), particles_.vertices()}});
}

template <class D>
std::vector<Vec3> DeviceEngine<D>::fill_mesh(const collision::TriangleMesh& mesh, float spacing) {
  return collision::lattice_points_inside(
      device_, collision::DeviceTriangleBvh(device_, collision::TriangleBvh(mesh)), spacing);
}

template <class D>
std::vector<float> DeviceEngine<D>::solid_distances(std::span<const Vec3> points, float reach,
                                                    const CollisionFilter& filter) {
  const auto count = static_cast<uint32_t>(points.size());
  pbd::Buffer<Vec3> in(device_, "points");
  pbd::Buffer<float> out(device_, "distances");
  replace(in, points);
  out.resize_discard(count);
  device_.parallel_for("shapes/distance", count,
                       engine_kernels::SolidDistance{shape_set_, in.view(), out.view(), reach, filter});
  return out.read(count);
}

template <class D>
std::optional<NearestSolid> DeviceEngine<D>::nearest_solid(Vec3 point, float reach) {
  pbd::Buffer<NearestSolid> out(device_, "nearest solid");
  out.resize_discard(1);
  device_.parallel_for("shapes/nearest", 1,
                       engine_kernels::FindNearest{shape_set_, point, reach, out.view()});
  const NearestSolid found = out.read(1).front();
  return found.distance < reach ? std::optional(found) : std::nullopt;
}

}  // namespace meniscus
