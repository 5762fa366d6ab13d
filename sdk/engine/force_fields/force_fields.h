// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The force fields of a world: what they do to particles, vertices and bodies in each substep.
#pragma once

#include <algorithm>

#include "collision/body/body_set.h"
#include "pbd/external_forces.h"
#include "pbd/substep.h"
#include "sdk/engine/force_fields/body_forces.h"
#include "sdk/engine/force_fields/greatest_force.h"

namespace meniscus {

namespace force_kernels {

struct FindChange {
  View<const pbd::Vec4> position, velocity;
  View<const pbd::Phase> phase;
  View<const ForceField> fields;
  View<const float> densities;  // kg/m³, by group of fluids and grains
  View<const float> volumes;    // m³, by vertex; empty if no field acts on volumes
  uint32_t first_vertex;
  View<pbd::Vec4> change;
  double time;
  float dt;

  MENISCUS_HD void operator()(uint32_t i) const {
    const pbd::Vec4 x = position[i];
    change[i] = {0, 0, 0, 0};
    if (x.w == 0) return;
    const bool is_vertex = (phase[i] & pbd::phase_vertex) != 0;
    const Felt felt{x.xyz(), is_vertex ? density_of_vertex(i, x.w) : densities[pbd::phase_group(phase[i])],
                    is_vertex                 ? ForceField::cloth
                    : pbd::is_grain(phase[i]) ? ForceField::grains
                                              : ForceField::fluids};
    change[i] = pbd::with_w(change_by_all(fields, felt, velocity[i].xyz(), time, dt), 0);
  }
  MENISCUS_HD float density_of_vertex(uint32_t i, float inverse_mass) const {
    const float volume = volumes.count ? volumes[i - first_vertex] : 0;
    return volume > 0 ? 1 / (inverse_mass * volume) : infinite_density;
  }
};

}  // namespace force_kernels

/// Forces that are data: see ForceFieldDef. Without any, nothing is launched or allocated.
template <class D>
class ForceFields final : public pbd::ExternalForces<D> {
 public:
  ForceFields(D& device, collision::RigidWorld& rigid, collision::BodySet<D>& bodies)
      : device_(device), rigid_(rigid), bodies_(bodies) {}

  /// `body_densities` is by body, kg/m³.
  void set(std::span<const ForceFieldModel> models, std::span<const float> body_densities,
           const VertexVolumes& vertices) {
    device_.wait();
    std::vector<pbd::Buffer<Vec3>> grids;
    std::vector<ForceField> on_host, on_device;
    for (const ForceFieldModel& model : models) {
      on_host.push_back(model.field);
      on_device.push_back(model.field);
      if (model.values.empty()) continue;
      pbd::Buffer<Vec3>& grid = grids.emplace_back(device_, "grids of force fields");
      grid.resize_discard(model.values.size());
      grid.write(model.values);
      on_device.back().values = grid.view();
    }
    pbd::Buffer<float> volumes(device_, "volumes of vertices");
    volumes.resize_discard(vertices.volumes.size());
    volumes.write(vertices.volumes);
    fields_.resize_or_stay(on_device.size());
    fields_.write(on_device);
    volumes_ = std::move(volumes);
    least_vertex_density_ = vertices.least_density;
    models_.assign(models.begin(), models.end());
    for (size_t k = 0; k < models_.size(); ++k)
      on_host[k].values = {models_[k].values.data(), static_cast<uint32_t>(models_[k].values.size())};
    on_host_ = std::move(on_host);
    grids_ = std::move(grids);
    body_densities_.assign(body_densities.begin(), body_densities.end());
    any_on_bodies_ = std::any_of(on_host_.begin(), on_host_.end(),
                                 [](const ForceField& f) { return (f.targets & ForceField::bodies) != 0; });
    make_room();
  }
  /// kg/m³, by group.
  void set_densities(std::span<const float> densities) {
    densities_.resize_discard(densities.size());
    densities_.write(densities);
    least_density_ = densities.empty() ? 1.0f : *std::min_element(densities.begin(), densities.end());
  }

  bool any() const override { return fields_.size() > 0; }
  float greatest_acceleration(Vec3 lower, Vec3 upper) const override {
    return force_kernels::greatest_acceleration(on_host_, std::min(least_density_, least_vertex_density_),
                                                lower, upper);
  }
  void reserve(uint32_t particles) override {
    capacity_ = particles;
    make_room();
  }
  void start_step() override {
    start_time_ = rigid_.time();
    passed_ = next_ = 0;
  }
  void start_substep(float dt) override {
    passed_ = next_;
    next_ = passed_ + double{dt};
    if (!any_on_bodies_) return;
    force_kernels::push_bodies(rigid_, on_host_, body_densities_, start_time_ + passed_, dt);
    bodies_.motions_changed();
  }
  pbd::View<const pbd::Vec4> velocity_changes(const pbd::ParticleView& start, float dt) override {
    device_.parallel_for("forces/fields", start.owned,
                         force_kernels::FindChange{start.position, start.velocity, start.phase,
                                                   fields_.view(), densities_.view(), volumes_.view(),
                                                   start.sorted, changes_.view(), start_time_ + passed_, dt});
    return changes_.view();
  }

 private:
  void make_room() {
    const size_t needed = any() ? capacity_ : 0;
    if (changes_.size() < needed || needed == 0) changes_.resize_discard(needed);
  }

  D& device_;
  collision::RigidWorld& rigid_;
  collision::BodySet<D>& bodies_;
  std::vector<ForceFieldModel> models_;
  std::vector<ForceField> on_host_;
  std::vector<pbd::Buffer<Vec3>> grids_;
  pbd::Buffer<ForceField> fields_{device_, "force fields"};
  pbd::Buffer<float> densities_{device_, "densities of materials"};
  pbd::Buffer<float> volumes_{device_, "volumes of vertices"};
  pbd::Buffer<pbd::Vec4> changes_{device_, "changes by force fields"};
  std::vector<float> body_densities_;
  float least_density_ = 1, least_vertex_density_ = std::numeric_limits<float>::infinity();  // kg/m³
  bool any_on_bodies_ = false;
  uint32_t capacity_ = 0;
  double start_time_ = 0, passed_ = 0, next_ = 0;  // s
};

}  // namespace meniscus
