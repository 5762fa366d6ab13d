// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of surface tension, and their launches.
#pragma once

#include <vector>

#include "fluid/forces/surface_tension_set.h"
#include "pbd/contacts.h"
#include "pbd/neighbours.h"

namespace meniscus::fluid {

namespace surface_tension_kernels {

using pbd::ContactView;
using pbd::NeighbourView;
using pbd::Vec3Of;
using pbd::Vec4;
using pbd::View;

/// v without the components that point away from the walls near particle i. Calls hold(contact, what was
/// removed from v).
template <class Hold>
MENISCUS_HD Vec3 held_by_walls(const ContactView& contacts, uint32_t i, Vec3 v, const Hold& hold) {
  for (uint32_t c = contacts.start[i]; c < contacts.start[i + 1]; ++c) {
    pbd::Contact& contact = contacts.contacts[c];
    const float away = contact.fraction * dot(v, contact.normal);
    if (!(away > 0)) continue;
    v -= away * contact.normal;
    hold(contact, away * contact.normal);
  }
  return v;
}

/// Copies each fluid's affinities to its particles.
struct Spread {
  View<const pbd::Phase> phase;
  View<const Affinity> table;
  View<float> cohesion, curvature;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Affinity a = table[pbd::phase_group(phase[i])];
    cohesion[i] = a.cohesion;
    curvature[i] = a.curvature;
  }
};

/// The normal n, which points into the fluid, and b beside it.
template <class K>
struct SurfaceNormal {
  K kernel;
  View<const Vec4> position;
  View<const float> curvature;
  NeighbourView neighbours;
  ContactView contacts;
  View<Vec4> normal;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    using Real = typename D::Real;
    const Vec4 self = position[i];
    Vec3Of<Real> n{Real(0.0f), Real(0.0f), Real(0.0f)};
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const Vec3Of<Real> d = self.xyz() - gather(position, j).xyz();
      n += (gather(curvature, j) * kernel.weight_slope(dot(d, d))) * d;
    });
    const Vec3 inwards = held_by_walls(contacts, i, kernel.h * sum(n), [](pbd::Contact&, Vec3) {});
    if (D::leads()) normal[i] = pbd::with_w(inwards, curvature[i]);
  }
};

template <class K>
struct Pull {
  K kernel;
  TensionKernel tension;
  bool bends;
  View<const Vec4> position, normal;
  View<const float> cohesion;
  NeighbourView neighbours;
  ContactView contacts;
  View<Vec4> velocity;
  float dt;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    using Real = typename D::Real;
    const Vec4 self = position[i], n = normal[i];
    const Real own(-cohesion[i]), scale(0.5f * tension.curvature_scale);
    Vec3Of<Real> force{Real(0.0f), Real(0.0f), Real(0.0f)};
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const Vec3Of<Real> d = self.xyz() - gather(position, j).xyz();
      const Real r2 = dot(d, d) + Real(tiny_distance2);
      const Real inverse_r = inverse_sqrt(r2);
      force += (own * gather(cohesion, j) * tension.attraction(r2 * inverse_r) * inverse_r) * d;
      if (bends) {
        const auto other = gather(normal, j);
        force += (scale * (Real(n.w) + other.w) * kernel.weight(r2)) * (other.xyz() - n.xyz());
      }
    });
    const Vec3 f = held_by_walls(contacts, i, sum(force), [&](pbd::Contact& contact, Vec3 taken) {
      if (D::leads()) contact.density_push -= (dt * dt) * taken;
    });
    if (D::leads()) velocity[i] = pbd::with_w(velocity[i].xyz() + (dt * self.w) * f, velocity[i].w);
  }
};

/// p = x + h·v with the present velocities, minus the part by which motions were limited.
struct PredictAnew {
  View<const Vec4> previous, velocity, accumulated_delta;
  View<Vec4> position;
  float dt;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 x = previous[i].xyz() + dt * velocity[i].xyz();
    position[i] = pbd::with_w(x + accumulated_delta[i].xyz(), position[i].w);
  }
};

}  // namespace surface_tension_kernels

template <class D>
void SurfaceTensionSet<D>::set_materials(std::span<const Material> materials) {
  std::vector<Affinity> affinities;
  pulls_ = bends_ = false;
  for (const Material& m : materials) {
    affinities.push_back(affinity_of(m));
    pulls_ |= affinities.back().cohesion > 0;
    bends_ |= affinities.back().curvature > 0;
  }
  table_.resize_discard(static_cast<uint32_t>(affinities.size()));
  table_.write(affinities);
  make_room();
}

template <class D>
void SurfaceTensionSet<D>::accelerate(pbd::Substep<D>& substep) {
  using namespace surface_tension_kernels;
  if (!pulls_ || !substep.particles.has_fluid()) return;
  const pbd::ParticleView& p = substep.particles;
  device_.parallel_for("tension/affinities", p.sorted,
                       Spread{p.phase, table_.view(), cohesion_.view(), curvature_.view()});
  refresh_ghosts(device_, substep.ghosts, cohesion_.view());
  if (bends_) refresh_ghosts(device_, substep.ghosts, curvature_.view());
  with_shape(kernel_, [&]<class K>(const K& kernel) {
    if (bends_) {
      device_.parallel_for_neighbours("tension/normals", p.sorted,
                                      SurfaceNormal<K>{kernel, p.position, curvature_.view(),
                                                       substep.neighbours, substep.contacts, normal_.view()});
      refresh_ghosts(device_, substep.ghosts, normal_.view());
    }
    device_.parallel_for_neighbours(
        "tension/pull", p.sorted,
        Pull<K>{kernel, tension_, bends_, p.position, normal_.view(), cohesion_.view(), substep.neighbours,
                substep.contacts, p.velocity, substep.dt});
  });
  device_.parallel_for("tension/predict", p.sorted,
                       PredictAnew{p.previous, p.velocity, p.accumulated_delta, p.position, substep.dt});
}

template <class D>
void SurfaceTensionSet<D>::reserve(uint32_t capacity, uint32_t) {
  capacity_ = capacity;
  make_room();
}

/// Allocates memory only if a fluid needs it.
template <class D>
void SurfaceTensionSet<D>::make_room() {
  const uint32_t size = capacity_ + pbd::Particles::padding;
  if (!pulls_ || cohesion_.size() == size) return;
  cohesion_.resize_discard(0);
  curvature_.resize_discard(size);
  normal_.resize_discard(size);
  cohesion_.resize_discard(size);  // last: its length is the one that is tested
  cohesion_.fill(0);
  curvature_.fill(0);
  normal_.fill(0);
}

}  // namespace meniscus::fluid
