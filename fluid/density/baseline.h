// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The interface of methods of others that solve for the fluid's pressure.
#pragma once

#include <memory>

#include "fluid/density/density_set.h"

namespace meniscus::fluid {

/// A published method in the place of the density constraint, for comparison. It has the neighbours, walls
/// and contacts of a substep, and finds pressures; DensitySet keeps its multipliers Λ = V h_t² p.
///
/// Neighbours are found once a substep, at the predicted positions x* = x + h_t v + h_t² g.
template <class D>
class Baseline {
 public:
  using Multipliers = pbd::View<density_kernels::Multiplier>;

  virtual ~Baseline() = default;
  virtual void set_parameters(const DensityParameters& parameters) = 0;
  /// `sentinel`: the particle with which neighbour lists are padded.
  virtual void reserve(uint32_t size, uint32_t sentinel) = 0;
  virtual void start_step() {}
  /// See ConstraintSet. It waits for the device.
  virtual int least_substeps(float dt, int chosen, const pbd::ParticleView& start) = 0;
  /// `scale`: of pressure to last substep's: the square of the ratio of their lengths.
  virtual void begin(pbd::Substep<D>&, Multipliers, float scale) = 0;
  virtual void project(pbd::Substep<D>&, Multipliers, int iteration) = 0;
  virtual void end(pbd::Substep<D>&, Multipliers) {}
  /// See DensitySet.
  virtual uint32_t iterations_done(uint32_t planned) const { return planned; }
};

template <class D>
std::unique_ptr<Baseline<D>> make_baseline(D& device, const Kernel& kernel,
                                           const DensityParameters& parameters);

}  // namespace meniscus::fluid
