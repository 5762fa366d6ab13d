// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The velocity pass for XSPH and vorticity confinement.
#pragma once

#include <span>
#include <vector>

#include "fluid/kernel/kernel.h"
#include "fluid/kernel/material.h"
#include "pbd/substep.h"

namespace meniscus::fluid {

template <class D>
class DensitySet;

namespace smoothing_kernels {
enum class Coefficients;
}

/// The coefficients of one fluid for a given step.
struct SmoothingCoefficients {
  float smoothing;    ///< c
  float confinement;  ///< ε
};

/// XSPH (Schechter & Bridson 2012) and vorticity confinement (Fedkiw, Stam & Jensen 2001), as in
/// Position Based Fluids, eqs. 15 to 17, with two changes that make the parameters independent of step and
/// spacing.
///
///   XSPH         v_i += c Σ 2w_i/(w_i + w_j) V W (v_j − v_i)
///                c = 1 − exp(−xsph h_t)
///   confinement  v_i += h_t ε h N × ω, N = ∇|ω|/|∇|ω||
///
/// N uses |ω| of the last substep, which moves with the particles, so that one pass over the neighbours
/// suffices. Particles that are new have none yet.
///
/// The mean of the masses conserves momentum between fluids of different density. Because of the factor h,
/// confinement vanishes with resolution.
///
/// In a crowd (crowd.h) c is divided by 1 + C. Σ V W grows with the density, and above 2/c the sum is
/// unstable.
template <class D>
class SmoothingPass final : public pbd::VelocityPass<D> {
 public:
  /// `density` tells where there is a crowd; without it there is none.
  SmoothingPass(D& device, const Kernel& kernel, const DensitySet<D>* density = nullptr)
      : device_(device), kernel_(kernel), density_(density) {}

  void set_materials(std::span<const Material> materials);
  void apply(pbd::Substep<D>& substep, pbd::Particles& particles) override;
  void reserve(uint32_t capacity) override;

 private:
  template <smoothing_kernels::Coefficients from, bool confines>
  void smooth(pbd::Substep<D>& substep, pbd::Particles& particles);
  pbd::View<const float> crowd() const;

  D& device_;
  Kernel kernel_;
  const DensitySet<D>* density_;
  std::vector<Material> materials_;
  bool smooths_ = false, confines_ = false, uniform_ = true;
  float table_dt_ = 0;
  std::vector<SmoothingCoefficients> host_table_;
  pbd::Buffer<SmoothingCoefficients> table_{device_, "fluid coefficients"};
  pbd::Buffer<float> smoothing_{device_, "particle smoothing"};
};

}  // namespace meniscus::fluid
