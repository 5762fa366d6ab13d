// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The order of all that takes part in a substep. Within an iteration each constraint set sees what those
// before it did, so the order is part of the method. docs/architecture.md says more.
#pragma once

#include <array>
#include <cstddef>

namespace meniscus {

/// Constraint sets, in the order in which each iteration projects them.
enum class SetPhase {
  surface_tension,     ///< changes velocities before the solve
  density,             ///< first, so that what follows corrects what it pushes into cloth and solids
  fluid_loads,         ///< gives cloth what the density solve pushed into its contacts
  attachments,         ///< before all that moves vertices: a held vertex weighs as much as its holder
  body_loads,          ///< before cloth: a vertex that carries a body resists with that body's mass
  cloth,               ///< stretch, shear, bending, tethers, volume
  body_load_transfer,  ///< after cloth, before contacts: hands on to bodies what cloth pressed
  rods,
  ropes,
  self_contact,        ///< after cloth's own constraints
  grains,              ///< friction among grains, with their contacts
  fluid_carry,         ///< after cloth: moves along the fluid that rests on it
  contacts,            ///< late, so that nothing is left inside a solid
  ccd_failsafe,        ///< after all that moves vertices: nothing has passed through cloth
  attachment_release,  ///< after all that moves vertices: these get their own masses back
  fluid_cloth,         ///< after all that moves vertices: no fluid has passed through cloth
  bodies,              ///< last: bodies take what all others gave them, and Bullet steps
  count,
};

constexpr const char* phase_name(SetPhase phase) {
  constexpr std::array names{"surface_tension",    "density",      "fluid_loads",
                             "attachments",        "body_loads",   "cloth",
                             "body_load_transfer", "rods",         "ropes",
                             "self_contact",       "grains",       "fluid_carry",
                             "contacts",           "ccd_failsafe", "attachment_release",
                             "fluid_cloth",        "bodies"};
  static_assert(names.size() == static_cast<std::size_t>(SetPhase::count));
  return names[static_cast<std::size_t>(phase)];
}

/// Sources of contacts, in the order in which a particle lists its contacts.
enum class ContactPhase {
  attachments,  ///< first: a vertex's attachment comes before what it touches
  cloth,
  solids,
  count,
};

constexpr const char* phase_name(ContactPhase phase) {
  constexpr std::array names{"attachments", "cloth", "solids"};
  static_assert(names.size() == static_cast<std::size_t>(ContactPhase::count));
  return names[static_cast<std::size_t>(phase)];
}

/// What changes velocities after the solve.
enum class VelocityPhase {
  jets,       ///< first: particles that have just left an opening keep its velocity
  viscosity,  ///< viscosity, XSPH and vorticity confinement
  count,
};

constexpr const char* phase_name(VelocityPhase phase) {
  constexpr std::array names{"jets", "viscosity"};
  static_assert(names.size() == static_cast<std::size_t>(VelocityPhase::count));
  return names[static_cast<std::size_t>(phase)];
}

}  // namespace meniscus
