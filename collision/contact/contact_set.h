// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "pbd/substep.h"

namespace meniscus::collision {

/// Keeps particles out of solids, with friction, restitution and adhesion.
///
///   normal    C = n·(p − point) − r ≥ 0, Δλ = −C/(w + w_b). The substep's multiplier is accumulated and
///             clamped at 0, so that a contact never pulls, and takes back what it pushed too far; with
///             adhesion it may pull so far.
///   friction  positional Coulomb friction (Macklin et al. 2014, eqs. 23 and 24): the substep's slip on the
///             surface is taken back up to μ times the normal load, the density constraint's pressure in it.
///   bounce    after the solve, the speed of parting is at least −e · (approach speed): what has met a
///             surface does not go on into it.
///
/// w_b is a body's inverse mass at the contact, split among its contacts (collision/body/body_set.h); 0 for
/// what is fixed.
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
