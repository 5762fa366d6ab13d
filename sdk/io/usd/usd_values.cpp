// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The values of a USD stage at a frame.
#include <numbers>

#include "pbd/math/vec.h"
#include "sdk/io/mesh_parts.h"
#include "sdk/io/point_sets.h"
#include "sdk/io/usd/usd_scene.h"
#include "sdk/io/usd/usd_text.h"

namespace meniscus::io {
namespace {

template <class T>
std::string array_of(const std::vector<T>& values) {
  return usd_array(std::span<const T>(values));
}

}  // namespace

std::vector<std::string> UsdScene::values(const SceneFrame& frame) const {
  Values values(stage_.varying.size());
  set_particles(frame, values);
  if (diffuse_) set_diffuse(frame, values);
  set_bodies(frame, values);
  if (!surface_.empty()) set_surface(frame.liquid, values);
  if (!cloth_.empty()) set_cloth(frame.cloth, values);
  if (!ropes_.empty()) set_ropes(frame.ropes, values);
  return values;
}

void UsdScene::set_particles(const SceneFrame& frame, Values& values) const {
  const std::vector<FluidPoints> fluids = points_by_fluid(frame, particles_.size());
  for (std::size_t f = 0; f < fluids.size(); ++f) {
    const PointNumbers& at = particles_[f];
    values[at.points] = array_of(fluids[f].positions);
    values[at.velocities] = array_of(fluids[f].velocities);
    values[at.ids] = array_of(fluids[f].ids);
    values[at.extent] = usd_extent(fluids[f].positions, 0.5f * spacing_);
  }
}

void UsdScene::set_diffuse(const SceneFrame& frame, Values& values) const {
  const DiffusePoints points = diffuse_points(frame.diffuse);
  values[diffuse_->points] = array_of(points.positions);
  values[diffuse_->velocities] = array_of(points.velocities);
  values[diffuse_->life] = array_of(points.lives);
  values[diffuse_->kind] = array_of(points.kinds);
  values[diffuse_->extent] = usd_extent(points.positions, 0.125f * spacing_);
}

void UsdScene::set_bodies(const SceneFrame& frame, Values& values) const {
  constexpr float degrees = 180 / std::numbers::pi_v<float>;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyState& state = frame.bodies.at(i);
    values[bodies_[i].place] = usd_value(state.pose.position);
    values[bodies_[i].turn] = usd_value(state.pose.rotation);
    values[bodies_[i].velocity] = usd_value(state.velocity);
    values[bodies_[i].spin] = usd_value(degrees * state.angular_velocity);
  }
}

void UsdScene::set_surface(const LiquidFrame& frame, Values& values) const {
  const std::vector<MeshPart> parts = parts_of(frame);
  for (std::size_t i = 0; i < surface_.size(); ++i) set_mesh(surface_[i], parts[i], frame, values);
}

void UsdScene::set_cloth(const ClothFrame& frame, Values& values) const {
  const std::vector<MeshPart> parts = parts_of(frame);
  for (std::size_t i = 0; i < cloth_.size(); ++i) set_mesh(cloth_[i], parts[i], frame, values);
}

template <class Frame>
void UsdScene::set_mesh(const MeshNumbers& at, const MeshPart& part, const Frame& frame, Values& values) {
  values[at.points] = usd_array(part.vertices(frame.vertices));
  values[at.velocities] = usd_array(part.vertices(frame.velocities));
  values[at.normals] = usd_array(part.vertices(frame.normals));
  values[at.extent] = usd_extent(part.vertices(frame.vertices));
  if (!at.counts) return;
  values[*at.counts] = triangle_counts(part.triangle_count);
  values[*at.corners] = triangle_corners(part.triangles(frame.triangles), part.first_vertex);
}

void UsdScene::set_ropes(const RopeFrame& frame, Values& values) const {
  for (std::size_t i = 0; i < ropes_.size(); ++i) {
    const RopePoints points = points_of_rope(frame, i);
    values[ropes_[i].points] = array_of(points.positions);
    values[ropes_[i].velocities] = array_of(points.velocities);
    values[ropes_[i].extent] = usd_extent(points.positions, rope_radii_[i]);
  }
}

}  // namespace meniscus::io
