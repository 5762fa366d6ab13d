// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels that sum up what probes measure.
#pragma once

#include "fluid/density/probes.h"

namespace meniscus::fluid {

namespace probe_kernels {

/// The kernel-weighted mean of the particles' pressures Λ / (V h_t²) around a point.
struct PointPressure {
  Kernel kernel;
  pbd::View<const pbd::Vec4> position;
  pbd::View<const density_kernels::Multiplier> multiplier;
  pbd::View<const pbd::Phase> phase;
  Vec3 point;
  float to_pressure;

  MENISCUS_HD ProbeSum operator()(uint32_t i) const {
    if (pbd::is_grain(phase[i])) return {};
    const Vec3 d = position[i].xyz() - point;
    const double weight = kernel.weight(dot(d, d));
    return {weight * (to_pressure * multiplier[i].value), weight, 0, 0, 0};
  }
};

/// The force on one fixed shape through the contacts of particle i.
struct WallForce {
  pbd::ContactView contacts;
  uint32_t shape;
  Aabb patch;
  float to_force;  ///< 1/h_t²

  MENISCUS_HD ProbeSum operator()(uint32_t i) const {
    ProbeSum total{};
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      const pbd::Contact& c = contacts.contacts[k];
      if (c.solid != shape || c.body != pbd::no_index || !inside(patch, c.point)) continue;
      const Vec3 f = -to_force * multiplier_sum(c);
      total.x += f.x;
      total.y += f.y;
      total.z += f.z;
    }
    return total;
  }
};

struct Add {
  MENISCUS_HD ProbeSum operator()(const ProbeSum& a, const ProbeSum& b) const {
    return {a.pressure + b.pressure, a.weight + b.weight, a.x + b.x, a.y + b.y, a.z + b.z};
  }
};

struct Accumulate {
  pbd::View<const ProbeSum> value;
  pbd::View<ProbeSum> totals;
  uint32_t probe;

  MENISCUS_HD void operator()(uint32_t) const { totals[probe] = Add{}(totals[probe], value[0]); }
};

}  // namespace probe_kernels

template <class D>
void Probes<D>::set_probes(std::span<const Probe> probes) {
  probes_.assign(probes.begin(), probes.end());
  value_.resize_discard(1);
  totals_.resize_discard(static_cast<uint32_t>(probes.size()));
  start_step();
}

template <class D>
void Probes<D>::start_step() {
  totals_.fill(0);
  substeps_ = 0;
}

template <class D>
void Probes<D>::observe(const pbd::Substep<D>& substep) {
  using namespace probe_kernels;
  const float inverse_dt2 = 1 / (substep.dt * substep.dt);
  const Kernel& kernel = density_.kernel();
  for (uint32_t k = 0; k < probes_.size(); ++k) {
    const Probe& probe = probes_[k];
    const uint32_t count = substep.particles.sorted;
    if (probe.at_point) {
      device_.reduce("probes/point", count, ProbeSum{},
                     PointPressure{kernel, substep.particles.position, density_.multipliers(),
                                   substep.particles.phase, probe.point, inverse_dt2 / kernel.volume},
                     Add{}, value_.view());
    } else {
      device_.reduce("probes/wall", count, ProbeSum{},
                     WallForce{substep.contacts, probe.shape, probe.patch, inverse_dt2}, Add{},
                     value_.view());
    }
    device_.parallel_for("probes/accumulate", 1, Accumulate{value_.view(), totals_.view(), k});
  }
  ++substeps_;
}

template <class D>
void Probes<D>::read(std::span<ProbeSum> means) const {
  totals_.read(means);
  for (ProbeSum& m : means) {
    if (m.weight > 0) m.pressure /= m.weight;
    if (substeps_ > 0)
      m = {m.pressure, m.weight / substeps_, m.x / substeps_, m.y / substeps_, m.z / substeps_};
  }
}

}  // namespace meniscus::fluid
