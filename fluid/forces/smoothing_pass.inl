// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of XSPH and vorticity confinement, and their launches.
#pragma once

#include <cmath>
#include <vector>

#include "fluid/density/density_set.h"
#include "fluid/forces/smoothing_pass.h"
#include "pbd/neighbours.h"

namespace meniscus::fluid {

namespace smoothing_kernels {

using pbd::NeighbourView;
using pbd::Vec3Of;
using pbd::Vec4;
using pbd::View;

/// Where the coefficient of smoothing comes from: all fluids have the same; they have the same but for a
/// crowd; or each particle has its own. Without a crowd, the first two give the same bits.
enum class Coefficients { common, thinned, own };

/// Copies each fluid's smoothing to its particles: the coefficient c, or the part of the common one. A pair
/// uses the mean.
struct SpreadSmoothing {
  Coefficients from;
  View<const pbd::Phase> phase;
  View<const SmoothingCoefficients> table;
  View<float> smoothing;
  View<const float> allowed;  // the compression of a crowd, if there is one

  MENISCUS_HD void operator()(uint32_t i) const {
    const float dense = allowed.count > 0 ? 1 + allowed[i] : 1.0f;
    const float c = from == Coefficients::own ? table[pbd::phase_group(phase[i])].smoothing : 1.0f;
    smoothing[i] = c / dense;
  }
};

template <class K, Coefficients from, bool confines>
struct Smooth {
  static constexpr uint32_t resident_blocks = 8;  // see CudaDevice

  K kernel;
  View<const Vec4> position;
  View<const Vec4> velocity;  ///< w: |ω| of the last substep
  NeighbourView neighbours;
  View<const pbd::Phase> phase;
  View<const SmoothingCoefficients> table;
  View<const float> smoothing;
  float common_smoothing, dt;
  View<Vec4> smoothed;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    using Real = typename D::Real;
    const Vec4 p = position[i], v = velocity[i];
    const float self = from == Coefficients::common ? 1.0f : smoothing[i];
    Vec3Of<Real> change{Real(0.0f), Real(0.0f), Real(0.0f)}, curl = change, rise = change;
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const auto other = gather(position, j);
      const Vec3Of<Real> d = p.xyz() - other.xyz();
      const Real t = kernel.distance_ratio2(d);
      const auto its = gather(velocity, j);
      const Vec3Of<Real> relative = its.xyz() - v.xyz();
      Real factor = K::weight_shape(t);
      if constexpr (from == Coefficients::thinned) {
        factor = factor * (Real(0.5f) * (Real(self) + gather(smoothing, j)));
      } else if constexpr (from == Coefficients::own) {
        factor = factor * (Real(self) + gather(smoothing, j)) * Real(p.w) / (Real(p.w) + other.w);
      }
      change += factor * relative;
      if constexpr (confines) {
        const Real inverse_root = inverse_sqrt(t);
        const Vec3Of<Real> slope = (K::slope_shape(t, inverse_root) * inverse_root) * d;
        curl += cross(relative, slope);
        rise += (Real(v.w) - its.w) * slope;
      }
    });
    const float fraction =
        from == Coefficients::own ? kernel.peak_weight : kernel.peak_weight * common_smoothing;
    const Vec3 all_changes = sum(change), all_curls = sum(curl), all_rises = sum(rise);
    if (!D::leads()) return;
    const Vec3 smooth = v.xyz() + fraction * all_changes;
    if constexpr (confines) {
      const Vec3 w = kernel.peak_pull * all_curls;
      const Vec3 direction =
          normalized_or(all_rises, {0, 0, 0});  // the kernel's constant factor does not matter
      const float strength = table[pbd::phase_group(phase[i])].confinement * kernel.h * dt;
      smoothed[i] = pbd::with_w(smooth + strength * cross(direction, w), length(w));
    } else {
      smoothed[i] = pbd::with_w(smooth, 0);
    }
  }
};

}  // namespace smoothing_kernels

template <class D>
void SmoothingPass<D>::set_materials(std::span<const Material> materials) {
  materials_.assign(materials.begin(), materials.end());
  table_.resize_discard(static_cast<uint32_t>(materials.size()));
  table_dt_ = 0;
  smooths_ = confines_ = false;
  uniform_ = true;
  for (const Material& m : materials_) {
    const Material& first = materials_.front();
    smooths_ |= m.xsph > 0;
    confines_ |= m.vorticity_confinement > 0;
    uniform_ &= m.xsph == first.xsph && m.rest_density == first.rest_density;
  }
}

template <class D>
void SmoothingPass<D>::apply(pbd::Substep<D>& substep, pbd::Particles& particles) {
  if (!substep.particles.has_fluid() || (!smooths_ && !confines_)) return;
  if (table_dt_ != substep.dt) {
    host_table_.clear();
    for (const Material& m : materials_)
      host_table_.push_back({-std::expm1(-m.xsph * substep.dt), m.vorticity_confinement});
    table_.write(host_table_);
    table_dt_ = substep.dt;
  }
  using enum smoothing_kernels::Coefficients;
  if (!uniform_) {
    confines_ ? smooth<own, true>(substep, particles) : smooth<own, false>(substep, particles);
  } else if (crowd().count > 0) {
    confines_ ? smooth<thinned, true>(substep, particles) : smooth<thinned, false>(substep, particles);
  } else {
    confines_ ? smooth<common, true>(substep, particles) : smooth<common, false>(substep, particles);
  }
}

template <class D>
template <smoothing_kernels::Coefficients from, bool confines>
void SmoothingPass<D>::smooth(pbd::Substep<D>& substep, pbd::Particles& particles) {
  using namespace smoothing_kernels;
  const pbd::ParticleView& p = substep.particles;
  if (from != Coefficients::common) {
    device_.parallel_for("velocity/coefficients", p.sorted,
                         SpreadSmoothing{from, p.phase, table_.view(), smoothing_.view(), crowd()});
    refresh_ghosts(device_, substep.ghosts, smoothing_.view());
  }
  refresh_ghosts(device_, substep.ghosts, p.velocity);
  with_shape(kernel_, [&]<class K>(const K& kernel) {
    device_.parallel_for_neighbours(
        "velocity/smooth", p.sorted,
        Smooth<K, from, confines>{kernel, p.position, p.velocity, substep.neighbours, p.phase, table_.view(),
                                  smoothing_.view(), host_table_.front().smoothing, substep.dt,
                                  particles.velocity.next.view()});
  });
  particles.keep_vertex_velocities();
  particles.velocity.flip();
  const uint32_t ghosts = p.ghosts;
  substep.particles = particles.view();
  substep.particles.ghosts = ghosts;
}

template <class D>
pbd::View<const float> SmoothingPass<D>::crowd() const {
  return density_ ? density_->allowed() : pbd::View<const float>{};
}

template <class D>
void SmoothingPass<D>::reserve(uint32_t capacity) {
  const uint32_t size = capacity + pbd::Particles::padding;
  smoothing_.resize_discard(size);
  smoothing_.fill(0);
}

}  // namespace meniscus::fluid
