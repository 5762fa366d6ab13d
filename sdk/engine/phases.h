// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The order of the phases of a substep. Within an iteration each constraint set sees the changes of those
// before it, so the order is part of the method. docs/architecture.md explains it.
#pragma once

#include <array>
#include <cstddef>

namespace meniscus {

/// Constraint sets, in the order in which each iteration projects them.
enum class SetPhase {
  pistons,             ///< first: opens walls at mouths, and takes back what moved particles of pistons
  surface_tension,     ///< changes velocities before the solve
  density,             ///< first, so that later sets correct what it pushes into cloth and solids
  fluid_loads,         ///< passes the density solve's contact impulses on to cloth
  driven_surfaces,     ///< before contacts are found: driven vertices are where their tracks have them
  attachments,         ///< before sets that move vertices: a held vertex gets its holder's mass
  stick_anchors,       ///< before friction: recalls where vertices have stuck to solids
  body_loads,          ///< before cloth: a vertex that carries a body resists with that body's mass
  cloth,               ///< stretch, shear, bending, tethers, volume
  body_load_transfer,  ///< after cloth, before contacts: transfers the impulses of cloth to bodies
  rods,
  ropes,
  self_contact,        ///< after cloth's own constraints
  grains,              ///< friction among grains, with their contacts
  fluid_carry,         ///< after cloth: moves the fluid that rests on it along
  contacts,            ///< late, so that nothing stays inside a solid
  ccd_failsafe,        ///< after sets that move vertices: nothing has passed through cloth
  body_zones,          ///< after sets that move vertices: no body has passed through cloth
  attachment_release,  ///< after sets that move vertices: vertices get their own masses back
  fluid_cloth,         ///< after sets that move vertices: no fluid has passed through cloth
  films,               ///< before bodies: loads them with the fluid in narrow gaps
  viscosity,           ///< before bodies, which receive what walls exert
  bodies,              ///< last: bodies receive the impulses of all others, and Bullet steps
  count,
};

constexpr const char* phase_name(SetPhase phase) {
  constexpr std::array names{"pistons",
                             "surface_tension",
                             "density",
                             "fluid_loads",
                             "driven_surfaces",
                             "attachments",
                             "stick_anchors",
                             "body_loads",
                             "cloth",
                             "body_load_transfer",
                             "rods",
                             "ropes",
                             "self_contact",
                             "grains",
                             "fluid_carry",
                             "contacts",
                             "ccd_failsafe",
                             "body_zones",
                             "attachment_release",
                             "fluid_cloth",
                             "films",
                             "viscosity",
                             "bodies"};
  static_assert(names.size() == static_cast<std::size_t>(SetPhase::count));
  return names[static_cast<std::size_t>(phase)];
}

/// Sources of contacts, in the order in which a particle lists its contacts.
enum class ContactPhase {
  attachments,  ///< first: a vertex lists its attachment before its contacts
  cloth,
  solids,
  count,
};

constexpr const char* phase_name(ContactPhase phase) {
  constexpr std::array names{"attachments", "cloth", "solids"};
  static_assert(names.size() == static_cast<std::size_t>(ContactPhase::count));
  return names[static_cast<std::size_t>(phase)];
}

/// Passes that change velocities after the solve.
enum class VelocityPhase {
  jets,       ///< first: particles that have just left an opening keep its velocity
  smoothing,  ///< XSPH and vorticity confinement
  count,
};

constexpr const char* phase_name(VelocityPhase phase) {
  constexpr std::array names{"jets", "smoothing"};
  static_assert(names.size() == static_cast<std::size_t>(VelocityPhase::count));
  return names[static_cast<std::size_t>(phase)];
}

}  // namespace meniscus
