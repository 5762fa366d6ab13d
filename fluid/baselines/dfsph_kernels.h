// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of DFSPH: the divergence of the velocity, and the warm start.
#pragma once

#include "fluid/baselines/pressure_kernels.h"
#include "fluid/baselines/tuning.h"

namespace meniscus::fluid::baseline_kernels {

/// h_t dC/dt = −h_t Σ e_ij · (v_i − v_j); 0 for a particle with few neighbours.
struct Divergence {
  BaselineKernel kernel;
  View<const Vec4> position, velocity;
  NeighbourView neighbours;
  View<const uint32_t> contact_start;
  float dt;
  View<float> compression;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    if (contact_start[i] != contact_start[i + 1]) return;
    using Real = typename D::Real;
    const Vec3 x = position[i].xyz(), v = velocity[i].xyz();
    Real rate(0.0f), count(0.0f);
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const Vec3Of<Real> d = x - gather(position, j).xyz(), relative = v - gather(velocity, j).xyz();
      const Real t = kernel.distance_ratio2(d), inverse_root = inverse_sqrt(t);
      rate += BaselineKernel::slope_shape(t, inverse_root) * inverse_root * dot(d, relative);
      count += select_less(t, Real(1.0f), Real(1.0f), Real(0.0f));
    });
    write<D>(i, sum(rate), sum(count));
  }

  template <class D>
  MENISCUS_HD void write(uint32_t i, float rate, float count) const {
    if (D::leads())
      compression[i] = count < baseline_tuning::least_neighbours ? 0 : -dt * kernel.peak_pull * rate;
  }
};

/// A mirror ghost of j moves with the mirrored velocity of j, relative to the wall: with
/// u_k = n_k · (v_j − v_wall), and D = x_i − x_j,
///   (x_i − x_j') · (v_i − v_j') = D · (v_i − v_j) + Σ_k 2 (d_jk n_k · (v_i − v_j) + u_k n_k · D + 2 d_jk
///   u_k)
/// over the ghost's mirrors. That is exact at right angles.
struct DivergenceAtWalls {
  Divergence open;
  ContactView contacts;

  template <class D>
  MENISCUS_HD void run(uint32_t k) const {
    const uint32_t i = contacts.touching_particle(k);
    if (i == pbd::no_index) return;
    const MirrorPlanes mirrors = mirrors_at(contacts, i, open.position[i].xyz(), open.kernel.h);
    mirrors.count <= 1 ? find<D, 1>(i, mirrors) : find<D, MirrorPlanes::most>(i, mirrors);
  }

  template <class D, int n>
  MENISCUS_HD void find(uint32_t i, const MirrorPlanes& mirrors) const {
    using Real = typename D::Real;
    const Vec3 x = open.position[i].xyz(), v = open.velocity[i].xyz();
    float wall_speed[n] = {};  // m/s, along the normals
    MENISCUS_UNROLL
    for (int k = 0; k < n; ++k) {
      if (!is_used<n>(mirrors, k) || k >= mirrors.count) break;
      const pbd::Contact& c = contacts.contacts[mirrors.contact[k]];
      wall_speed[k] = dot(c.normal, c.surface_motion) / open.dt;
    }
    Real rate(0.0f), count(0.0f);
    const auto add = [&](const Real& fraction, const Real& r2, const Real& product) {
      const Real t = Real(open.kernel.inverse_h2) * r2, inverse_root = inverse_sqrt(t);
      rate += fraction * BaselineKernel::slope_shape(t, inverse_root) * inverse_root * product;
      count += fraction * select_less(t, Real(1.0f), Real(1.0f), Real(0.0f));
    };
    pbd::for_each_neighbour<D>(open.neighbours, i, [&](auto j) {
      const auto other = gather(open.position, j).xyz();
      const auto its = gather(open.velocity, j).xyz();
      const Vec3Of<Real> d = x - other, relative = v - its;
      const Real r2 = dot(d, d) + Real(tiny_distance2), product = dot(d, relative);
      add(Real(1.0f), r2, product);
      add_ghosts<n>(mirrors, MirrorDistances<Real, n>(mirrors, other), d, relative, its, wall_speed, r2,
                    product, add);
    });
    float self_rate = 0, self_count = 0;
    const auto add_self = [&](float fraction, float r2, float product) {
      const float t = open.kernel.inverse_h2 * r2, inverse_root = inverse_sqrt(t);
      self_rate += fraction * BaselineKernel::slope_shape(t, inverse_root) * inverse_root * product;
      self_count += fraction * select_less(t, 1.0f, 1.0f, 0.0f);
    };
    MirrorDistances<float, n> self;
    MENISCUS_UNROLL
    for (int k = 0; k < n; ++k) {
      self.distance[k] = mirrors.distance[k];
      self.present[k] = 1;
    }
    const Vec3Of<float> none{0, 0, 0};
    add_ghosts<n>(mirrors, self, none, none, Vec3Of<float>{v.x, v.y, v.z}, wall_speed, float{tiny_distance2},
                  0.0f, add_self);
    open.write<D>(i, sum(rate) + self_rate, sum(count) + self_count);
  }

  template <int n, class R, class Add>
  MENISCUS_HD static void add_ghosts(const MirrorPlanes& m, const MirrorDistances<R, n>& j,
                                     const Vec3Of<R>& d, const Vec3Of<R>& relative,
                                     const Vec3Of<R>& its_velocity, const float (&wall_speed)[n], const R& r2,
                                     const R& product, const Add& add) {
    MENISCUS_UNROLL
    for (int ghost = 1; ghost < 1 << n; ++ghost) {
      if (ghost > m.ghost_count()) break;
      R fraction(m.fraction[ghost]), ghost_r2 = r2, ghost_product = product;
      MENISCUS_UNROLL
      for (int k = 0; k < n; ++k) {
        if (!(ghost >> k & 1)) continue;
        const Vec3Of<R> normal{R(m.normal[k].x), R(m.normal[k].y), R(m.normal[k].z)};
        const R speed = dot(normal, its_velocity) - R(wall_speed[k]);
        fraction = fraction * j.present[k];
        ghost_r2 += R(4 * m.distance[k]) * j.distance[k];
        ghost_product += R(2.0f) * (j.distance[k] * dot(normal, relative) + speed * dot(normal, d) +
                                    R(2.0f) * j.distance[k] * speed);
      }
      add(fraction, ghost_r2, ghost_product);
    }
  }
};

/// Stages a fraction of the last substep's Λ of the density solver. Between substeps Multiplier::value is the
/// sum over both solvers, and Multiplier::relieved the part of the divergence solver.
struct StartDensity {
  float scale;     ///< of pressures to those of the last substep
  float fraction;  ///< that is kept
  View<Multiplier> multiplier;
  View<Vec4> staged;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Multiplier last = multiplier[i];
    const float start = scale * fraction * pbd::max(0.0f, last.value - last.relieved);
    multiplier[i] = {start, scale * fraction * last.relieved};
    staged[i].w = start;
  }
};

struct StartDivergence {
  View<const Multiplier> multiplier;
  View<Vec4> staged;

  MENISCUS_HD void operator()(uint32_t i) const { staged[i].w = multiplier[i].relieved; }
};

/// Pressure is that of both solvers.
struct AddDivergence {
  View<Multiplier> multiplier;

  MENISCUS_HD void operator()(uint32_t i) const { multiplier[i].value += multiplier[i].relieved; }
};

}  // namespace meniscus::fluid::baseline_kernels
