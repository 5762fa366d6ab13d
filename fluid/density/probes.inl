// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of Probes; its kernels are in probe_kernels.h.
#pragma once

#include <numbers>
#include <vector>

#include "fluid/density/probe_kernels.h"
#include "fluid/density/probes.h"

namespace meniscus::fluid {

template <class D>
void Probes<D>::set_probes(std::span<const Probe> probes) {
  probes_.assign(probes.begin(), probes.end());
  value_.resize_discard(1);
  layers_.resize_discard(probe_kernels::most_layers);
  totals_.resize_discard(static_cast<uint32_t>(probes.size()));
  exact_value_.resize_discard(1);
  exact_totals_.resize_discard(static_cast<uint32_t>(probes.size()));
  start_step();
}

template <class D>
void Probes<D>::start_step() {
  totals_.fill(0);
  exact_totals_.fill(0);
  substeps_ = 0;
}

template <class D>
template <class Map>
void Probes<D>::sum(const char* name, const pbd::Substep<D>& substep, const Map& map) {
  using namespace probe_kernels;
  if (is_exact_)
    device_.reduce(name, substep.particles.sorted, ExactProbeSum{}, Exactly<Map>{map}, AddExactly{},
                   exact_value_.view());
  else
    device_.reduce(name, substep.particles.sorted, ProbeSum{}, map, Add{}, value_.view());
}

/// Adds the value of the present substep.
template <class D>
void Probes<D>::accumulate(uint32_t probe) {
  using namespace probe_kernels;
  const bool is_level = probes_[probe].measure == ProbeMeasure::level;
  if (is_exact_ && !is_level)
    device_.parallel_for("probes/accumulate", 1,
                         AccumulateExactly{exact_value_.view(), exact_totals_.view(), probe});
  else
    device_.parallel_for("probes/accumulate", 1, Accumulate{value_.view(), totals_.view(), probe});
}

/// All ranks then find the same level.
template <class D>
void Probes<D>::add_layers_over_ranks() {
  const std::vector<uint32_t> own = layers_.read(layers_.size());
  std::vector<uint64_t> all(own.begin(), own.end());
  exchange_->add_up(all);
  layers_.write(std::vector<uint32_t>(all.begin(), all.end()));
}

template <class D>
void Probes<D>::measure_level(const pbd::Substep<D>& substep, const Probe& probe) {
  using namespace probe_kernels;
  const float area = std::numbers::pi_v<float> * probe.radius * probe.radius;
  layers_.fill(0);
  device_.parallel_for("probes/layers", substep.particles.sorted,
                       CountLayers{substep.particles.position, axes_, probe.point, probe.normal, probe.radius,
                                   spacing_, layers_.view()});
  if (exchange_) add_layers_over_ranks();
  device_.parallel_for("probes/level", 1,
                       FindLevel{layers_.view(), area / (spacing_ * spacing_), spacing_, value_.view()});
}

template <class D>
void Probes<D>::observe(const pbd::Substep<D>& substep) {
  using namespace probe_kernels;
  using enum ProbeMeasure;
  const float inverse_dt2 = 1 / (substep.dt * substep.dt);
  const pbd::ParticleView& p = substep.particles;
  exchange_ = substep.ghosts.exchange;
  is_exact_ = exchange_ || device_.fixes_sums();
  for (uint32_t k = 0; k < probes_.size(); ++k) {
    const Probe& probe = probes_[k];
    switch (probe.measure) {
      case pressure:
        with_shape(density_.kernel(), [&]<class K>(const K& kernel) {
          sum("probes/point", substep,
              PointPressure<K>{kernel, p.position, density_.multipliers(), p.phase, axes_, probe.point,
                               inverse_dt2 / kernel.particle_volume});
        });
        break;
      case velocity:
        with_shape(density_.kernel(), [&]<class K>(const K& kernel) {
          sum("probes/velocity", substep,
              PointVelocity<K>{kernel, p.position, p.velocity, axes_, probe.point});
        });
        break;
      case density:
        with_shape(density_.kernel(), [&]<class K>(const K& kernel) {
          sum("probes/density", substep,
              PointDensity<K>{kernel, p.position, axes_, probe.point, spacing_ * spacing_ * spacing_});
        });
        break;
      case force:
      case torque:
        sum("probes/wall", substep,
            WallForce{substep.contacts, probe.shape, probe.patch, inverse_dt2, probe.measure == torque,
                      probe.point});
        break;
      case flow:
        sum("probes/flow", substep,
            DiscFlow{p.position, p.velocity, axes_, probe.point, probe.normal, probe.radius, spacing_});
        break;
      case level:
        measure_level(substep, probe);
        break;
      case momentum:
      case angular_momentum:
      case centre:
        sum("probes/fluid", substep,
            FluidSum{probe.measure, p.position, p.velocity, p.phase, probe.group, probe.point});
        break;
    }
    accumulate(k);
  }
  ++substeps_;
}

template <class D>
void Probes<D>::read(std::span<ProbeSum> means) const {
  totals_.read(means);
  if (is_exact_) read_exactly(means);
  for (ProbeSum& m : means) {
    const double parts = m.weight > 0 ? m.weight : substeps_;
    if (parts > 0) m = {m.value / parts, m.weight, m.x / parts, m.y / parts, m.z / parts};
  }
}

/// Of all probes but levels.
template <class D>
void Probes<D>::read_exactly(std::span<ProbeSum> sums) const {
  std::vector<probe_kernels::ExactProbeSum> exact = exact_totals_.read(exact_totals_.size());
  if (exchange_) add_over_ranks(*exchange_, exact);
  for (size_t k = 0; k < sums.size(); ++k) {
    const pbd::ExactSum(&s)[probe_kernels::ExactProbeSum::count] = exact[k].sums;
    if (probes_[k].measure != ProbeMeasure::level)
      sums[k] = {s[0].value(), s[1].value(), s[2].value(), s[3].value(), s[4].value()};
  }
}

}  // namespace meniscus::fluid
