// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Probes: what is measured in each substep, and averaged over a step.
#pragma once

#include <span>
#include <vector>

#include "fluid/density/density_set.h"
#include "fluid/density/exact_probes.h"
#include "pbd/math/periodic_axes.h"
#include "pbd/substep.h"

namespace meniscus::fluid {

enum class ProbeMeasure {
  pressure,          ///< at a point; Pa
  velocity,          ///< at a point; m/s
  density,           ///< at a point; kg/m³
  force,             ///< on a shape; N
  torque,            ///< on a shape, about a point; N·m
  flow,              ///< through a disc; m³/s
  level,             ///< of the free surface in a column; m
  momentum,          ///< of a fluid; kg·m/s
  angular_momentum,  ///< of a fluid, about a point; kg·m²/s
  centre,            ///< of mass of a fluid; m
};

/// One thing that is measured.
struct Probe {
  ProbeMeasure measure = ProbeMeasure::pressure;
  Vec3 point{0, 0, 0};
  uint32_t shape = 0;                ///< pbd::Contact::solid
  Aabb patch{{0, 0, 0}, {0, 0, 0}};  ///< contacts whose point lies inside count
  Vec3 normal{0, 1, 0};              ///< unit, of the disc or along the column
  float radius = 0;                  ///< m, of the disc or column
  uint32_t group = pbd::no_index;    ///< the fluid; no_index: all
};

/// Measures the probes in every substep, and averages over a step. Along periodic axes a particle counts
/// where its nearest image is. With fixed sums, and in a world that ranks share, sums are exact.
template <class D>
class Probes final : public pbd::Observer<D> {
 public:
  Probes(D& device, const DensitySet<D>& density, float spacing, const pbd::PeriodicAxes& axes)
      : device_(device), density_(density), spacing_(spacing), axes_(axes) {}

  void set_probes(std::span<const Probe> probes);
  std::span<const Probe> probes() const { return probes_; }
  void start_step() override;
  void observe(const pbd::Substep<D>& substep) override;
  /// One element for each probe: the mean over the last step's substeps. All ranks call it.
  void read(std::span<ProbeSum> means) const;

 private:
  template <class Map>
  void sum(const char* name, const pbd::Substep<D>& substep, const Map& map);
  void measure_level(const pbd::Substep<D>& substep, const Probe& probe);
  void add_layers_over_ranks();
  void accumulate(uint32_t probe);
  void read_exactly(std::span<ProbeSum> sums) const;

  D& device_;
  const DensitySet<D>& density_;
  float spacing_;  // m
  pbd::PeriodicAxes axes_;
  std::vector<Probe> probes_;
  int substeps_ = 0;
  bool is_exact_ = false;                   // in the present step
  pbd::GhostExchange* exchange_ = nullptr;  // of a shared world
  pbd::Buffer<ProbeSum> value_{device_, "probe value"};
  pbd::Buffer<uint32_t> layers_{device_, "probe layers"};
  pbd::Buffer<ProbeSum> totals_{device_, "probe totals"};
  pbd::Buffer<probe_kernels::ExactProbeSum> exact_value_{device_, "probe value"};
  pbd::Buffer<probe_kernels::ExactProbeSum> exact_totals_{device_, "probe totals"};
};

}  // namespace meniscus::fluid
