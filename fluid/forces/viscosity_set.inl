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

/// Whether fluid slips freely on all of them.
inline bool is_free(std::span<const float> slip_lengths) {
  return std::all_of(slip_lengths.begin(), slip_lengths.end(), [](float l) { return std::isinf(l); });
}

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
  shape_slip_.assign(shapes.begin(), shapes.end());
  body_slip_.assign(bodies.begin(), bodies.end());
  write_slip();
}

template <class D>
void ViscositySet<D>::set_cloth(std::span<const float> pieces) {
  cloth_slip_.assign(pieces.begin(), pieces.end());
  write_slip();
}

template <class D>
void ViscositySet<D>::write_slip() {
  std::vector<float> all;
  for (const auto* part : {&shape_slip_, &body_slip_, &cloth_slip_})
    all.insert(all.end(), part->begin(), part->end());
  if (is_free(all)) all.clear();  // no kernel reads them
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
  choose_vertices(substep);
  const Forces<uniform> forces = forces_of<uniform>(substep);
  if (slip_.size() > 0) weigh_walls(substep, forces);
  if (vertices_) weigh_cloth(substep);
  const double stiffness = 10 * substep.dt * kinematic_viscosity_ * weight_sum_;

  refresh_ghosts(device_, substep.ghosts, p.velocity);
  ++number_;
  device_.parallel_for("viscosity/begin", 1, Begin{progress_.view()});
  if (vertices_) solve_vertices(substep, p.velocity, {}, p.velocity);
  device_.parallel_for_neighbours("viscosity/start", p.sorted,
                                  Start<uniform>{forces, p.velocity, residual_.view()});
  refresh_ghosts(device_, substep.ghosts, residual_.view());
  iterate(substep, forces, stiffness);
  finish(substep, forces);
}

template <class D>
template <bool uniform>
void ViscositySet<D>::iterate(pbd::Substep<D>& substep, const viscosity_kernels::Forces<uniform>& forces,
                              double stiffness) {
  using namespace viscosity_kernels;
  const uint32_t particles = substep.particles.sorted;
  const double tolerance = forces_tuning::viscosity_tolerance / (1 + stiffness / 3);
  const uint32_t most = most_iterations(stiffness);
  for (uint32_t k = 0; k < most; ++k) {
    if (vertices_) solve_vertices(substep, residual_.view(), {}, {});
    device_.parallel_for_neighbours(
        "viscosity/multiply", particles,
        Multiply<uniform>{forces, progress_.view(), residual_.view(), product_.view()});
    device_.reduce("viscosity/dots", particles, Dots{},
                   MeasureDots{progress_.view(), residual_.view(), product_.view()}, AddDots{}, dots_.view());
    device_.parallel_for("viscosity/decide", 1,
                         Decide{dots_.view(), progress_.view(), ended_.view(), tolerance * tolerance});
    // What follows returns at once. When the host learns of it varies, without an effect on the results.
    if (*static_cast<const volatile uint32_t*>(ended_.host().data()) == number_) break;
    device_.parallel_for("viscosity/advance", particles,
                         Advance{progress_.view(), product_.view(), residual_.view(), direction_.view(),
                                 along_direction_.view(), change_.view()});
    refresh_ghosts(device_, substep.ghosts, residual_.view());
  }
}

template <class D>
template <bool uniform>
void ViscositySet<D>::finish(pbd::Substep<D>& substep, const viscosity_kernels::Forces<uniform>& forces) {
  using namespace viscosity_kernels;
  const pbd::ParticleView& p = substep.particles;
  if (vertices_) {
    solve_vertices(substep, p.velocity, change_.view(), p.velocity);
    device_.parallel_for("viscosity/finish vertices", vertices_,
                         FinishVertices{vertices_of(substep), p.velocity, substep.dt});
  }
  device_.parallel_for(
      "viscosity/finish", p.sorted,
      Finish<uniform>{forces, progress_.view(), residual_.view(), change_.view(), p.velocity});
}

template <class D>
template <bool uniform>
viscosity_kernels::Forces<uniform> ViscositySet<D>::forces_of(const pbd::Substep<D>& substep) {
  const double volume = spacing_ * spacing_ * spacing_;
  return {.kernel = kernel_,
          .scale = static_cast<float>(10 * substep.dt * volume * peak_weight_),
          .common_viscosity = common_viscosity_,
          .viscosity = viscosity_.view(),
          .position = substep.particles.position,
          .neighbours = substep.neighbours,
          .walls = walls_of(substep)};
}

template <class D>
viscosity_kernels::Walls ViscositySet<D>::walls_of(const pbd::Substep<D>& substep) {
  return {.contacts = substep.contacts.of_first(substep.particles.sorted),
          .weights = wall_weights_.view().first(slip_.size() > 0 ? substep.contacts.contacts.count : 0),
          .dt = substep.dt,
          .cloth = cloth_.view().first(vertices_ ? static_cast<uint32_t>(cloth_.size()) : 0)};
}

/// π K h⁴ I(b)/(8 s³) is the half-space's part of Σ φ z n_t², over its distance.
template <class D>
double ViscositySet<D>::wall_scale(float dt) const {
  const double h4 = double{kernel_.h2} * kernel_.h2;
  return 10 * dt * std::numbers::pi * peak_weight_ * h4 / 8;
}

/// Decides whether vertices of cloth take part, and makes room for it.
template <class D>
void ViscositySet<D>::choose_vertices(const pbd::Substep<D>& substep) {
  if (slip_.size() > 0 && wall_weights_.size() != substep.contacts.contacts.count)
    wall_weights_.resize_discard(substep.contacts.contacts.count);
  vertices_ = means_ && !is_free(cloth_slip_) ? means_->vertices() : 0;
  if (!vertices_) return;
  for (auto* buffer : {&cloth_, &cloth_force_}) {
    if (buffer->size() != substep.contacts.contacts.count)
      buffer->resize_discard(substep.contacts.contacts.count);
  }
  for (auto* buffer : {&vertex_sums_, &vertex_diagonal_, &vertex_mixed_, &vertex_velocity_}) {
    if (buffer->size() != vertices_) buffer->resize_discard(vertices_);
  }
  // A force up to that of the nearest particle possible, at 1,000 m/s. Contact radii are .01 spacings or
  // more.
  const double least_distance = forces_tuning::least_wall_distance * 0.01 * spacing_;
  const double most = 1000 * wall_scale(substep.dt) * common_viscosity_ / least_distance;
  sum_unit_ = static_cast<float>(std::ldexp(1.0, std::ilogb(most) - 51));
}

template <class D>
template <bool uniform>
void ViscositySet<D>::weigh_walls(const pbd::Substep<D>& substep,
                                  const viscosity_kernels::Forces<uniform>& forces) {
  using namespace viscosity_kernels;
  const auto first_body = static_cast<uint32_t>(shape_slip_.size());
  const double ratio = std::sqrt(double{kernel_.h2}) / spacing_;
  device_.parallel_for_neighbours(
      "viscosity/walls", substep.particles.sorted,
      WeighWalls<uniform>{
          forces, slip_.view(), first_body, first_body + static_cast<uint32_t>(body_slip_.size()),
          static_cast<float>(wall_scale(substep.dt)),
          static_cast<float>(std::numbers::pi * ratio * ratio * ratio / 3), wall_weights_.view()});
}

template <class D>
void ViscositySet<D>::weigh_cloth(const pbd::Substep<D>& substep) {
  using namespace viscosity_kernels;
  device_.parallel_for("viscosity/cloth", static_cast<uint32_t>(cloth_force_.size()),
                       WeighCloth{substep.contacts.of_first(substep.particles.sorted), wall_weights_.view(),
                                  cloth_force_.view()});
  for (const bool diagonal : {true, false}) {
    device_.parallel_for("viscosity/projections", static_cast<uint32_t>(cloth_force_.size()),
                         Projections{substep.contacts, cloth_force_.view(), diagonal});
    means_->to_vertices(cloth_force_.view(), vertex_sums_.view(), sum_unit_);
    device_.parallel_for(
        "viscosity/keep", vertices_,
        KeepSums{vertex_sums_.view(), diagonal ? vertex_diagonal_.view() : vertex_mixed_.view()});
  }
}

/// Solves for what vertices do where particles have `vector`, plus `change` if there is a view, and gives it
/// to the contacts. `before`: v* of the vertices, by particle; empty: 0.
template <class D>
void ViscositySet<D>::solve_vertices(const pbd::Substep<D>& substep, pbd::View<const pbd::Vec4> vector,
                                     pbd::View<const pbd::Vec4> change, pbd::View<const pbd::Vec4> before) {
  using namespace viscosity_kernels;
  device_.parallel_for("viscosity/drag", static_cast<uint32_t>(cloth_force_.size()),
                       DragCloth{substep.contacts, cloth_force_.view(), vector, change, progress_.view()});
  means_->to_vertices(cloth_force_.view(), vertex_sums_.view(), sum_unit_);
  device_.parallel_for("viscosity/vertices", vertices_, SolveVertices{vertices_of(substep), before});
  means_->to_contacts(vertex_velocity_.view(), cloth_.view());
}

template <class D>
viscosity_kernels::Vertices ViscositySet<D>::vertices_of(const pbd::Substep<D>& substep) {
  return {substep.particles.sorted, vertex_sums_.view(),     vertex_diagonal_.view(),
          vertex_mixed_.view(),     vertex_velocity_.view(), withstanding(substep)};
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
