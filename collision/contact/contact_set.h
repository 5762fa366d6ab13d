// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraint set that solves the contacts of particles: normal, friction and restitution.
#pragma once

#include "pbd/substep.h"

namespace meniscus::collision {

/// Keeps particles out of solids, with friction, restitution and adhesion:
///
///   normal    C = n·(p − point) − r ≥ 0, Δλ = −C/(w + w_b). The multiplier is accumulated over the substep
///             and clamped at 0. So a contact never pulls, and an iteration can undo what an earlier one
///             pushed too far. With adhesion the multiplier may be negative, down to a bound.
///   friction  positional Coulomb friction (Macklin et al. 2014, eqs. 23 and 24): the substep's slip along
///             the surface is taken back, up to μ times the normal load. The load includes the pressure that
///             the density constraint exerts on the contact.
///   bounce    after the solve, the speed of separation is at least −e · (approach speed). With e = 0 a
///             particle that has met a surface does not move on into it.
///
/// w_b is a body's inverse mass at the contact, split among its contacts (collision/body/body_set.h). It is 0
/// for a fixed solid.
template <class D>
class ContactSet final : public pbd::ConstraintSet<D> {
 public:
  explicit ContactSet(D& device) : device_(device) {}

  void project(pbd::Substep<D>& substep, int iteration) override;
  void end(pbd::Substep<D>& substep) override;

 private:
  D& device_;
};

}  // namespace meniscus::collision
