// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraint set that gives cloth vertices the effective mass of the bodies that they press on.
#pragma once

#include "collision/body/body_set.h"

namespace meniscus::collision {

namespace effective_mass_kernels {
struct BodyContacts;
}

/// Gives cloth vertices the effective mass of the bodies that they press on. Cloth may be thousands of times
/// lighter than a body that it supports. To chains its vertices seem to yield to any pull. What contacts push
/// them back with then moves the body by next to nothing in each iteration. A ball of fifteen times the
/// cloth's mass fell through.
///
/// So a vertex that a contact pushes, or is about to, resists motion across its chain by what is behind it as
/// well, 1/w_b (Substep::effective_mass): its fraction of the body, as for contacts (BodySet). What it has
/// pressed that with, the contact transfers to the body; along its chain it slides as it did. Friction comes
/// before the chains, not after them: with the load of a heavy body it holds a light vertex wherever it is,
/// and what comes last must leave chains at their lengths. What lies between a body and something behind it
/// has two-sided contacts (collision/contact/two_sided_contact.h).
///
/// Must come before the cloth's sets. transfer() must come after them, and before the contacts.
template <class D>
class EffectiveMass final : public pbd::ConstraintSet<D> {
 public:
  EffectiveMass(D& device, const BodySet<D>& bodies) : device_(device), bodies_(bodies), transfer_(*this) {}

  pbd::ConstraintSet<D>& transfer() { return transfer_; }
  /// Sets the number of vertices of all cloth.
  void set_vertices(uint32_t count) { vertices_ = count; }

  void begin(pbd::Substep<D>& substep) override;
  void project(pbd::Substep<D>& substep, int iteration) override;

 private:
  struct Transfer final : pbd::ConstraintSet<D> {
    explicit Transfer(EffectiveMass& owner) : vertices(owner) {}
    void project(pbd::Substep<D>& substep, int) override { vertices.transfer_push(substep); }
    EffectiveMass& vertices;
  };
  void transfer_push(pbd::Substep<D>& substep);
  effective_mass_kernels::BodyContacts contacts(const pbd::Substep<D>& substep) const;

  D& device_;
  const BodySet<D>& bodies_;
  Transfer transfer_;
  uint32_t vertices_ = 0;
  pbd::Buffer<pbd::Vec4> effective_mass_{device_, "effective masses"};
};

}  // namespace meniscus::collision
