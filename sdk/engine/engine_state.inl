// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The list of DeviceEngine's state.
#pragma once

#include "sdk/engine/engine.inl"

namespace meniscus {

/// Parts that are not listed make all that they have from models, definitions or the present substep. Results
/// of the last step that a user may ask for are state as well, unless the world has read them already.
template <class D>
void DeviceEngine<D>::visit_state(pbd::StateVisitor& v) {
  if (!v.restores()) ranks_ ? fetched_contacts_.clear() : static_cast<void>(read_contacts());
  // One that loads what ranks have saved needs room for the particles of all.
  uint32_t fluid = std::max(fluid_capacity_, all_particles_), vertices = vertex_capacity_;
  v.value("fluid_capacity", fluid);
  v.value("vertex_capacity", vertices);
  if (v.restores() && (fluid > fluid_capacity_ || vertices > vertex_capacity_))
    reserve(std::max(fluid, fluid_capacity_), std::max(vertices, vertex_capacity_));
  v.value("last_substep", last_substep_);
  v.value("any_overlapping", any_overlapping_);
  v.value("sorted_in_step", sorted_in_step_);
  v.list("contact", fetched_contacts_);
  contacts_fetched_ = true;
  v.part("solver", solver_);
  v.part("bodies", bodies_);
  v.part("stick_anchors", stick_anchors_);
  v.part("density", density_);
  v.part("cloth", cloth_);
  v.part("rods", rods_);
  v.part("ropes", ropes_);
  v.part("self_contacts", self_contacts_);
  v.part("grains", grains_);
  v.part("face_points", face_points_);
  v.part("body_zones", body_zones_);
  v.part("fluid_cloth", fluid_cloth_);
  v.part("jets", jets_);
  if (diffuse_) v.part("diffuse", *diffuse_);
}

}  // namespace meniscus
