// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Probes: places where the pressure, or the force of the fluid on a solid, is averaged over a step.
#pragma once

#include <span>
#include <vector>

#include "fluid/density/density_set.h"
#include "pbd/substep.h"

namespace meniscus::fluid {

/// One place where the fluid is measured.
struct Probe {
  bool at_point = true;  ///< pressure at `point`; else the force on a shape
  Vec3 point{0, 0, 0};
  uint32_t shape = 0;                ///< pbd::Contact::solid
  Aabb patch{{0, 0, 0}, {0, 0, 0}};  ///< contacts whose point lies inside count
};

/// The sums of a probe: for a weighted mean of the pressure, or a force.
struct ProbeSum {
  double pressure, weight;  ///< Σ p V W and Σ V W, in Pa and 1
  double x, y, z;           ///< N, of the fluid on the shape
};

/// Measures the probes in every substep, and averages over a step.
template <class D>
class Probes final : public pbd::Observer<D> {
 public:
  Probes(D& device, const DensitySet<D>& density) : device_(device), density_(density) {}

  void set_probes(std::span<const Probe> probes);
  void start_step() override;
  void observe(const pbd::Substep<D>& substep) override;
  /// One element for each probe: the mean over the last step's substeps.
  void read(std::span<ProbeSum> means) const;

 private:
  D& device_;
  const DensitySet<D>& density_;
  std::vector<Probe> probes_;
  int substeps_ = 0;
  pbd::Buffer<ProbeSum> value_{device_, "probe value"};
  pbd::Buffer<ProbeSum> totals_{device_, "probe totals"};
};

}  // namespace meniscus::fluid
