// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How DeviceEngine puts its parts together: the order in which the solver runs them.
#pragma once

#include "sdk/engine/engine.inl"

namespace meniscus {

template <class D>
void DeviceEngine<D>::assemble() {
  pbd::Pipeline<ContactPhase, pbd::ContactSource<D>>()
      .place(ContactPhase::attachments, attachments_)
      .place(ContactPhase::cloth, fluid_cloth_contacts_)
      .place(ContactPhase::solids, contacts_)
      .for_each([this](auto& source) { solver_.add(source); });
  pbd::Pipeline<SetPhase, pbd::ConstraintSet<D>>()
      .place(SetPhase::pistons, pistons_)
      .place(SetPhase::surface_tension, tension_)
      .place(SetPhase::density, density_)
      .place(SetPhase::fluid_loads, fluid_cloth_.loading())
      .place(SetPhase::attachments, attachments_)
      .place(SetPhase::stick_anchors, stick_anchors_)
      .place(SetPhase::body_loads, effective_mass_)
      .place(SetPhase::cloth, cloth_)
      .place(SetPhase::body_load_transfer, effective_mass_.transfer())
      .place(SetPhase::rods, rods_)
      .place(SetPhase::ropes, ropes_)
      .place(SetPhase::self_contact, self_contacts_)
      .place(SetPhase::grains, grains_)
      .place(SetPhase::fluid_carry, fluid_cloth_.carrying())
      .place(SetPhase::contacts, face_points_)
      .place(SetPhase::ccd_failsafe, self_contacts_.ccd_failsafe())
      .place(SetPhase::body_zones, body_zones_)
      .place(SetPhase::attachment_release, attachments_.release())
      .place(SetPhase::fluid_cloth, fluid_cloth_)
      .place(SetPhase::films, films_)
      .place(SetPhase::viscosity, viscosity_)
      .place(SetPhase::bodies, bodies_)
      .for_each([this](auto& set) { solver_.add(set); });
  pbd::Pipeline<VelocityPhase, pbd::VelocityPass<D>>()
      .place(VelocityPhase::jets, jets_)
      .place(VelocityPhase::smoothing, smoothing_)
      .for_each([this](auto& pass) { solver_.add(pass); });
  solver_.add(forces_);
  solver_.add(probes_);
  solver_.add(static_cast<pbd::Observer<D>&>(cloth_));
  solver_.add(static_cast<pbd::Observer<D>&>(attachments_));
}

template <class D>
void DeviceEngine<D>::add_diffuse(const fluid::DiffuseParameters& parameters) {
  diffuse_.emplace(device_, parameters);
  diffuse_->set_walls([this](const fluid::PendingDiffuse& pending) {
    device_.parallel_for("diffuse/walls", pending.particles.count,
                         KeepOutOfSolids{shape_set_, pending, def_.solver.support_radius});
  });
  solver_.add(*diffuse_);
}

}  // namespace meniscus
