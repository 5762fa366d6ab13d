// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "pbd/substep.h"

namespace meniscus::collision {

/// Keeps particles out of solids, with friction and restitution.
///
///   normal    C = n·(p − point) − r ≥ 0. The substep's multiplier is accumulated and clamped at 0, so that
///             a contact never pulls, and takes back what it pushed too far.
///   friction  positional Coulomb friction (Macklin et al. 2014, eqs. 23 and 24): the substep's slip is
///             taken back up to μ times the normal load, the pressure of the density constraint counted in.
///   bounce    after the solve, v·n ≥ −e · (approach speed): what has met a surface does not go on into it.
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
