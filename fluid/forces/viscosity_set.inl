// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The solve of viscosity, as launches of kernels, and its buffers.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fluid/forces/viscosity_set.h"

namespace meniscus::fluid {

template <class D>
ViscositySet<D>::ViscositySet(D& device, const Kernel& kernel, double spacing)
    : device_(device), kernel_(kernel), spacing_(spacing) {
  const double ratio = double{kernel.h} / spacing;  // h over s
  const int reach = static_cast<int>(std::ceil(ratio));
  double weights = 0, shear = 0;  // Σ φ/K and Σ φ x² y²/(K r²) over the rest lattice, in spacings
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j <= reach; ++j) {
      for (int k = -reach; k <= reach; ++k) {
        const double r2 = i * i + j * j + k * k, u = 1 - r2 / (ratio * ratio);
        if (r2 == 0 || u <= 0) continue;
        weights += u * u;
        shear += u * u * (i * i) * (j * j) / r2;
      }
    }
  }
  peak_weight_ = 1 / (5 * shear * spacing * spacing);
  weight_sum_ = peak_weight_ * weights;
  dots_.resize_discard(1);
  progress_.resize_discard(1);
  progress_.fill(0);
  ended_.resize_discard(1);
  ended_.host()[0] = 0;
}

template <class D>
void ViscositySet<D>::set_materials(std::span<const Material> materials) {
  std::vector<float> viscosities;
  float most = 0;
  for (const Material& m : materials) {
    viscosities.push_back(m.dynamic_viscosity);
    most = std::max(most, m.dynamic_viscosity);
  }
  acts_ = most > 0;
  uniform_ = std::all_of(viscosities.begin(), viscosities.end(), [&](float v) { return v == most; });
  common_viscosity_ = most;
  kinematic_viscosity_ = 0;
  for (const Material& m : materials) {
    // Grains have none of their own, and take up to the greatest.
    const double own = m.dynamic_viscosity > 0 ? double{m.dynamic_viscosity} : double{most};
    const double between = acts_ ? 2 * own * most / (own + most) : 0;
    kinematic_viscosity_ = std::max(kinematic_viscosity_, between / m.rest_density);
  }
  table_.resize_discard(static_cast<uint32_t>(viscosities.size()));
  table_.write(viscosities);
  make_room();
}

template <class D>
void ViscositySet<D>::set_walls(std::span<const float> shapes, std::span<const float> bodies) {
  std::vector<float> all(shapes.begin(), shapes.end());
  all.insert(all.end(), bodies.begin(), bodies.end());
  const bool all_free = std::all_of(all.begin(), all.end(), [](float l) { return std::isinf(l); });
  if (all_free) all.clear();  // no kernel reads them
  first_body_ = static_cast<uint32_t>(shapes.size());
  slip_.resize_discard(static_cast<uint32_t>(all.size()));
  slip_.write(all);
}

template <class D>
void ViscositySet<D>::end(pbd::Substep<D>& substep) {
  if (!acts_ || substep.particles.sorted == 0) return;
  if (uniform_) return solve<true>(substep);
  device_.parallel_for(
      "viscosity/fluids", substep.particles.sorted,
      viscosity_kernels::ViscosityOf{substep.particles.phase, table_.view(), viscosity_.view()});
  refresh_ghosts(device_, substep.ghosts, viscosity_.view());
  solve<false>(substep);
}

template <class D>
template <bool uniform>
void ViscositySet<D>::solve(pbd::Substep<D>& substep) {
  using namespace viscosity_kernels;
  const pbd::ParticleView& p = substep.particles;
  const double h4 = double{kernel_.h2} * kernel_.h2;
  const double volume = spacing_ * spacing_ * spacing_;
  // π K h⁴ I(b)/(8 s³) is the half-space's part of Σ φ z n_t², over its distance.
  const double wall = 10 * substep.dt * std::numbers::pi * peak_weight_ * h4 / 8;
  const Walls walls{substep.contacts.of_first(p.sorted),
                    slip_.view(),
                    first_body_,
                    static_cast<float>(wall),
                    kernel_.inverse_h2,
                    substep.dt};
  const Forces<uniform> forces{.kernel = kernel_,
                               .scale = static_cast<float>(10 * substep.dt * volume * peak_weight_),
                               .common_viscosity = common_viscosity_,
                               .viscosity = viscosity_.view(),
                               .position = p.position,
                               .neighbours = substep.neighbours,
                               .walls = walls};
  const double stiffness = 10 * substep.dt * kinematic_viscosity_ * weight_sum_;
  const double tolerance = forces_tuning::viscosity_tolerance / (1 + stiffness / 3);

  refresh_ghosts(device_, substep.ghosts, p.velocity);
  ++number_;
  device_.parallel_for("viscosity/begin", 1, Begin{progress_.view()});
  device_.parallel_for_neighbours("viscosity/start", p.sorted,
                                  Start<uniform>{forces, p.velocity, residual_.view()});
  refresh_ghosts(device_, substep.ghosts, residual_.view());
  const uint32_t most = most_iterations(stiffness);
  for (uint32_t k = 0; k < most; ++k) {
    device_.parallel_for_neighbours(
        "viscosity/multiply", p.sorted,
        Multiply<uniform>{forces, progress_.view(), residual_.view(), product_.view()});
    device_.reduce("viscosity/dots", p.sorted, Dots{},
                   MeasureDots{progress_.view(), residual_.view(), product_.view()}, AddDots{}, dots_.view());
    device_.parallel_for("viscosity/decide", 1,
                         Decide{dots_.view(), progress_.view(), ended_.view(), tolerance * tolerance});
    // What follows returns at once. When the host learns of it varies, without an effect on the results.
    if (*static_cast<const volatile uint32_t*>(ended_.host().data()) == number_) break;
    device_.parallel_for("viscosity/advance", p.sorted,
                         Advance{progress_.view(), product_.view(), residual_.view(), direction_.view(),
                                 along_direction_.view(), change_.view()});
    refresh_ghosts(device_, substep.ghosts, residual_.view());
  }
  device_.parallel_for(
      "viscosity/finish", p.sorted,
      Finish<uniform>{forces, progress_.view(), residual_.view(), change_.view(), p.velocity});
}

/// So many iterations reach the tolerance where no particle has more neighbours than half as much again as at
/// rest: an iteration reduces the error by the factor (√κ − 1)/(√κ + 1).
template <class D>
uint32_t ViscositySet<D>::most_iterations(double stiffness) const {
  const double root = std::sqrt(1 + stiffness);
  const double wanted = 2 * root * (1 + stiffness / 3) / forces_tuning::viscosity_tolerance;
  const double count = std::ceil(std::log(wanted) / std::log((root + 1) / (root - 1))) + 2;
  return static_cast<uint32_t>(std::min(count, double{forces_tuning::most_viscosity_iterations}));
}

template <class D>
void ViscositySet<D>::make_room() {
  const uint32_t size = acts_ && capacity_ > 0 ? capacity_ + pbd::Particles::padding : 0;
  viscosity_.resize_discard(acts_ && !uniform_ ? size : 0);
  // Neighbour lists end with particles that do not exist.
  viscosity_.fill(0);
  for (auto* buffer : {&residual_, &product_, &direction_, &along_direction_, &change_})
    buffer->resize_discard(size);
  residual_.fill(0);
}

template <class D>
void ViscositySet<D>::reserve(uint32_t capacity, uint32_t) {
  capacity_ = capacity;
  make_room();
}

}  // namespace meniscus::fluid
