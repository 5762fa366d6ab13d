// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of FluidClothSet; its kernels are in load.h and passing.h.
#pragma once

#include <cmath>

#include "collision/fluid_cloth/fluid_cloth_contacts.inl"
#include "collision/fluid_cloth/fluid_cloth_set.h"
#include "collision/fluid_cloth/means.h"
#include "collision/fluid_cloth/passing.h"

namespace meniscus::collision {

template <class D>
void FluidClothSet<D>::start(pbd::Substep<D>& substep) {
  using namespace fluid_cloth_kernels;
  if (!contacts_.any()) return;
  substep.fluid_near = contacts_.entry_start();
  const pbd::ParticleView& p = substep.particles;
  const pbd::View<pbd::Vec4> position = p.position.from(p.sorted);
  at_particles("fluid cloth/start", StartTouches{at_touches(substep)});
  at_vertices("fluid cloth/share",
              ShareMomentum{loaded_vertices(), position, p.accumulated_delta.from(p.sorted),
                            p.previous.from(p.sorted), change_.view()});
  at_particles("fluid cloth/give momentum", GiveMomentum{at_touches(substep), change_.view()});
  pbd::parallel_for_teams<TouchTeam>(
      device_, "fluid cloth/give", most_touches * contacts_.near_count(),
      NoteGive{contacts_.near(), loaded_vertices(), position, substep.contacts.contacts});
}

template <class D>
void FluidClothSet<D>::push_back(pbd::Substep<D>& substep, bool last) {
  using namespace fluid_cloth_kernels;
  if (!contacts_.any()) return;
  const pbd::ParticleView& p = substep.particles;
  at_particles("fluid cloth/follow", FollowCloth{at_touches(substep), true});
  at_vertices("fluid cloth/push back",
              PushVertices{loaded_vertices(), p.position.from(p.sorted), p.accumulated_delta.from(p.sorted)});
  if (last) carry(substep);
}

template <class D>
void FluidClothSet<D>::carry(pbd::Substep<D>& substep) {
  using namespace fluid_cloth_kernels;
  if (!contacts_.any()) return;
  at_particles("fluid cloth/carry", FollowCloth{at_touches(substep), false});
}

template <class D>
void FluidClothSet<D>::settle(pbd::Substep<D>& substep) {
  using namespace fluid_cloth_kernels;
  if (!contacts_.any()) return;
  const pbd::ParticleView& p = substep.particles;
  carry(substep);  // because fail-safes of other sets have moved vertices since
  device_.parallel_for("fluid cloth/unload", contacts_.vertices(),
                       Unload{loaded_vertices(), p.position.from(p.sorted), loaded_.view()});
  contacts_.clamp_at_impact(substep);
}

template <class D>
void FluidClothSet<D>::end(pbd::Substep<D>& substep) {
  using namespace fluid_cloth_kernels;
  if (!contacts_.any()) return;
  const pbd::ParticleView& p = substep.particles;
  device_.parallel_for("fluid cloth/weigh velocities", contacts_.near_count(),
                       WeighVelocities{at_touches(substep)});
  at_vertices("fluid cloth/load velocities",
              LoadVelocities{loaded_vertices(), loaded_.view(), p.velocity.from(p.sorted), change_.view(),
                             withstanding(substep), p.sorted, 1 / substep.dt});
  at_particles("fluid cloth/carry velocities", CarryVelocities{at_touches(substep), change_.view(),
                                                               p.velocity, particles_.phase.current.view()});
  if (contacts_.permeable()) pass(substep);
}

template <class D>
void FluidClothSet<D>::pass(pbd::Substep<D>& substep) {
  using namespace fluid_cloth_kernels;
  const pbd::View<pbd::Contact> contacts = substep.contacts.contacts;
  device_.parallel_for("fluid cloth/pushes", most_touches * contacts_.near_count(),
                       NotePushes{contacts_.near(), contacts, substep.particles.position});
  at_vertices("fluid cloth/drive", DrivePassing{loaded_vertices(), change_.view()});
  at_particles(
      "fluid cloth/pass",
      BeginPassing{contacts_.near(), contacts, contacts_.pieces(), change_.view(), substep.particles.position,
                   substep.particles.number, particles_.phase.current.view(), draws_++, substep.dt});
}

template <class D>
void FluidClothSet<D>::to_contacts(pbd::View<const pbd::Vec4> values, pbd::View<pbd::Vec4> means) {
  using namespace fluid_cloth_kernels;
  pbd::parallel_for_teams<TouchTeam>(device_, "fluid cloth/means", most_touches * contacts_.near_count(),
                                     MeansAtContacts{contacts_.near(), values, means});
}

template <class D>
void FluidClothSet<D>::to_vertices(pbd::View<const pbd::Vec4> values, pbd::View<pbd::Vec4> sums, float unit) {
  using namespace fluid_cloth_kernels;
  LoadedVertices loaded = loaded_vertices();
  loaded.unit = unit;
  at_vertices("fluid cloth/sums", SumsAtVertices{loaded, values, sums});
}

/// Launches a team for each near particle.
template <class D>
template <class Kernel>
void FluidClothSet<D>::at_particles(const char* name, const Kernel& kernel) {
  pbd::parallel_for_teams<fluid_cloth_kernels::TouchTeam>(device_, name, contacts_.near_count(), kernel);
}

/// Launches a team for each vertex.
template <class D>
template <class Kernel>
void FluidClothSet<D>::at_vertices(const char* name, const Kernel& kernel) {
  pbd::parallel_for_teams<fluid_cloth_kernels::VertexTeam>(device_, name, contacts_.vertices(), kernel);
}

template <class D>
fluid_cloth_kernels::AtTouches FluidClothSet<D>::at_touches(const pbd::Substep<D>& substep) {
  const pbd::ParticleView& p = substep.particles;
  return {contacts_.near(), substep.contacts.contacts,
          p.position,       p.accumulated_delta,
          p.previous,       p.phase,
          p.sorted,         substep.dt * substep.dt * substep.gravity,
          gravities_,       substep.dt * substep.dt};
}

template <class D>
fluid_cloth_kernels::LoadedVertices FluidClothSet<D>::loaded_vertices() {
  return {contacts_.entry_start(), contacts_.entries(), contacts_.near().touches, self_weight_.view(), unit_};
}

template <class D>
void FluidClothSet<D>::set_vertices(std::span<const float> inverse_masses, float heaviest) {
  self_weight_.resize_discard(inverse_masses.size());
  self_weight_.write(inverse_masses);
  loaded_.resize_discard(inverse_masses.size());
  change_.resize_discard(inverse_masses.size());
  // A vertex can carry about 2¹³ times the heaviest mass, or get that mass times as many metres.
  unit_ = std::ldexp(1.0f, std::ilogb(heaviest) - 49);
}

}  // namespace meniscus::collision
