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
  void set_shapes(const ShapeSet& shapes, bool only_planes) {
    shapes_ = shapes;
    only_planes_ = only_planes;
  }

  void limit_motion(pbd::View<const pbd::Vec4> from, pbd::View<pbd::Vec4> to, uint32_t count,
                    bool planes_too) override;
  void count(const pbd::Substep<D>& substep, pbd::View<uint32_t> counts) override;
  void fill(const pbd::Substep<D>& substep, const pbd::ContactWriter& writer) override;

 private:
  template <bool only_planes>
  auto finder(const pbd::Substep<D>& substep) const;

  D& device_;
  float support_radius_, contact_radius_;
  ShapeSet shapes_;
  bool only_planes_ =
      true;  // a tank and nothing in it, as so often: its kernels need a third of the registers
};

}  // namespace meniscus::collision
