// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of viscosity_set.h that weigh walls.
#pragma once

#include "fluid/forces/viscosity_kernels.h"

namespace meniscus::fluid::viscosity_kernels {

/// The integral of (1 − q)² (q − b)²/q over q from b to 1.
MENISCUS_HD inline float beyond_wall(float b) {
  if (!(b < 1)) return 0;
  const float c = 1 + b, b2 = b * b;
  const float log_term = b > 0 ? b2 * logf(b) : 0.0f;
  return pbd::max(0.0f, 0.25f * (1 - b2 * b2) - (2.0f / 3) * c * (1 - b2 * b) +
                            0.5f * (c * c + 2 * b) * (1 - b2) - 2 * b * c * (1 - b) - log_term);
}

/// The integral of (1 − q²)³ over q from b to 1.
MENISCUS_HD inline float count_beyond(float b) {
  if (!(b < 1)) return 0;
  const float b2 = b * b;
  return 16.0f / 35 - b * (1 - b2 * (1 - b2 * (0.6f - b2 / 7)));
}

/// h_t times the coefficients of the viscous forces by walls, kg. A body takes part with its share of mass,
/// so that the force cannot overshoot. Vertices of cloth are part of the solve.
///
/// A wall completes its particle: in a linear shear, whose velocity is that of the wall one slip length
/// behind it, no force is left. The part of the neighbours that is missing has a mirror image about the
/// particle: those further from the wall than twice the particle. They tell what the wall exerts. Beside a
/// surface they lack as well. There the integral over the half-space takes their place.
template <bool uniform>
struct WeighWalls {
  Forces<uniform> forces;
  View<const float> slip;  ///< m, of each fixed shape, then of each body, then of each piece of cloth
  uint32_t first_body, first_piece;
  float integral_scale;  ///< kg·m/(Pa·s), of a unit of beyond_wall()/m
  float count_scale;     ///< of a unit of count_beyond(): neighbours, weighted with (1 − r²/h²)²
  View<float> weights;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    const ContactView& contacts = forces.walls.contacts;
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      const float a = weight<D>(i, contacts.contacts[k]);
      if (D::leads()) weights[k] = a;
    }
  }

 private:
  MENISCUS_HD float slip_length(const Contact& c) const {
    const bool is_cloth = c.body == pbd::on_cloth;
    if ((is_cloth && forces.walls.cloth.count == 0) || c.solid == pbd::no_index) return HUGE_VALF;
    return slip[c.solid + (is_cloth ? first_piece : c.body == pbd::no_index ? 0 : first_body)];
  }

  template <class D>
  MENISCUS_HD float weight(uint32_t i, const Contact& c) const {
    using Real = typename D::Real;
    const float length = slip_length(c), self = forces.viscosity_of(i);
    if (!(length < pbd::most_finite) || !(self > 0)) return 0;
    const Vec4 p = forces.position[i];
    const float d = pbd::max(plane_distance(c, p.xyz()), forces_tuning::least_wall_distance * c.radius);
    const Vec3 n = c.normal;
    Real moment(0.0f), count(0.0f);
    pbd::for_each_neighbour<D>(forces.neighbours, i, [&](auto j) {
      const Vec3Of<Real> r = gather(forces.position, j).xyz() - p.xyz();
      const Real t = forces.kernel.distance_ratio2(r), u = unit_part(Real(1.0f) - t);
      const Real y = Real(n.x) * r.x + Real(n.y) * r.y + Real(n.z) * r.z;
      const Real near = select_less(Real(d), y, u * u, Real(0.0f));
      Real part = near * y * (Real(1.0f) - y * y * Real(forces.kernel.inverse_h2) / t);
      if constexpr (!uniform) part *= viscosity_between(self, gather(forces.viscosity, j));
      moment += part;
      count += near;
    });
    const float b = d * sqrtf(forces.kernel.inverse_h2);
    const float expected = count_scale * count_beyond(b);
    const float lacking = expected > 0 ? pbd::max(0.0f, 1 - sum(count) / expected) : 0.0f;
    const float of_neighbours = 0.5f * forces.scale * sum(moment) * (uniform ? self : 1.0f);
    const float a =
        c.fraction * (of_neighbours + lacking * integral_scale * self * beyond_wall(b * b)) / (d + length);
    return c.body == pbd::on_cloth ? a : a / (1 + a * c.body_inverse_mass);
  }
};

}  // namespace meniscus::fluid::viscosity_kernels
