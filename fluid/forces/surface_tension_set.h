// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraint set that applies surface tension before the solve.
#pragma once

#include <span>

#include "fluid/forces/surface_tension.h"
#include "pbd/substep.h"

namespace meniscus::fluid {

/// The forces of fluid/forces/surface_tension.h. They are opposite and equal, and explicit. A substep must be
/// shorter than about √(ρ₀ s³/(2πσ)), for the shortest capillary wave (Brackbill, Kothe & Zemach 1992). They
/// act before the solve, because the pressure that they cause belongs to the same substep. Otherwise a thin
/// layer would be pulled first and pressed later, and would oscillate.
///
/// A wall extends a surface like a mirror, so that fluid meets it at a right angle. The wall's mirror ghosts
/// cancel forces that point away from it. The contacts record these forces, so that the solid receives the
/// opposite.
template <class D>
class SurfaceTensionSet final : public pbd::ConstraintSet<D> {
 public:
  SurfaceTensionSet(D& device, const Kernel& kernel, double spacing)
      : device_(device), kernel_(kernel), tension_(calibrate_tension(kernel, spacing)) {}

  void set_materials(std::span<const Material> materials);
  void project(pbd::Substep<D>&, int) override {}
  void accelerate(pbd::Substep<D>& substep) override;
  void reserve(uint32_t capacity, uint32_t kept) override;

 private:
  void make_room() override;

  D& device_;
  Kernel kernel_;
  TensionKernel tension_;
  bool pulls_ = false, bends_ = false;
  uint32_t capacity_ = 0;
  pbd::Buffer<Affinity> table_{device_, "fluid affinities"};
  pbd::Buffer<float> cohesion_{device_, "cohesion"};
  pbd::Buffer<float> curvature_{device_, "curvature"};
  pbd::Buffer<pbd::Vec4> normal_{device_, "surface normals"};
};

}  // namespace meniscus::fluid
