// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Sealed components of the pressure grid, in which the pressure has no absolute value.
#pragma once

#include "fluid/pressure_grid/multigrid.h"
#include "fluid/pressure_grid/sealed_component_kernels.h"
#include "pbd/device/buffer.h"

namespace meniscus::fluid {

/// Finds sealed components: completely filled parts of the fluid. If no node of a component touches air, and
/// no solid can move, the equation has a solution only if the total excess is 0. The pressure then has an
/// undetermined constant. So the total excess is subtracted, in proportion to each node's volume, and the
/// pressure is relative to its minimum.
template <class D>
class SealedComponents {
 public:
  explicit SealedComponents(D& device) : device_(device) {}

  void reserve(uint32_t nodes) {
    label_.resize_discard(nodes);
    component_.resize_discard(nodes);
    sums_.resize_discard(nodes);
  }

  /// Makes the right side one with a solution. `volume` is that of a particle, m³.
  void level(const NodeTable& nodes, pbd::View<const uint32_t> flags, const multigrid_kernels::Level& finest,
             pbd::View<const float> filled, float volume) {
    using namespace grid_kernels;
    const uint32_t count = nodes.count();
    const Components components{nodes, flags, finest.coefficients, label_.view(), sums_.view()};
    device_.parallel_for("grid/start components", count, StartComponents{components});
    device_.parallel_for("grid/unite nodes", count, UniteNodes{components});
    device_.parallel_for("grid/mark open", count, MarkOpen{components});
    device_.parallel_for("grid/add up components", count,
                         AddUpComponents{components, finest.right, filled, volume, component_.view()});
    device_.parallel_for("grid/surplus", count,
                         TakeSurplus{component_.view(), sums_.view(), filled, volume, finest.right});
  }

  grid_kernels::PressureOf pressure(const NodeTable& nodes, pbd::View<const float> solution) {
    using namespace grid_kernels;
    device_.parallel_for("grid/least", nodes.count(), FindLeast{component_.view(), solution, sums_.view()});
    return {solution, component_.view(), sums_.view()};
  }

 private:
  D& device_;
  pbd::Buffer<uint32_t> label_{device_, "grid labels"};
  pbd::Buffer<uint32_t> component_{device_, "grid components"};
  pbd::Buffer<grid_kernels::ComponentSums> sums_{device_, "grid components"};
};

}  // namespace meniscus::fluid
