// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/shape.h"
#include "pbd/substep.h"

namespace meniscus::collision {

/// Finds the contacts of particles with shapes that do not move.
template <class D>
class ShapeContacts final : public pbd::ContactSource<D> {
 public:
  ShapeContacts(D& device, float support_radius, float contact_radius)
      : device_(device), support_radius_(support_radius), contact_radius_(contact_radius) {}

  /// The views must stay valid until they are set anew.
  void set_shapes(const ShapeSet& shapes) { shapes_ = shapes; }

  void count(const pbd::Substep<D>& substep, pbd::View<uint32_t> counts) override;
  void fill(const pbd::Substep<D>& substep, pbd::View<uint32_t> cursor,
            pbd::View<pbd::Contact> contacts) override;

 private:
  D& device_;
  float support_radius_, contact_radius_;
  ShapeSet shapes_;
};

}  // namespace meniscus::collision
