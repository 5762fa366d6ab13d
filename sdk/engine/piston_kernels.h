// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels of the pistons that imposed emitters push: their particles, and the walls at their mouths.
#pragma once

#include "collision/contact/shape.h"
#include "pbd/contacts.h"
#include "pbd/math/exact_sum.h"
#include "pbd/particles.h"
#include "sdk/engine/engine.h"

namespace meniscus::piston_kernels {

using pbd::Vec4;
using pbd::View;

/// The particles of all pistons, by ascending slot.
struct Table {
  View<const PistonParticle> particles;
  View<const Piston> pistons;

  /// The place of a slot in the table, or no_index.
  MENISCUS_HD uint32_t find(uint32_t slot) const {
    uint32_t low = 0, high = particles.count;
    while (low < high) {
      const uint32_t middle = (low + high) / 2;
      if (particles[middle].slot < slot)
        low = middle + 1;
      else
        high = middle;
    }
    return low < particles.count && particles[low].slot == slot ? low : pbd::no_index;
  }
  MENISCUS_HD const Piston& piston_of(uint32_t at) const { return pistons[particles[at].piston]; }
};

MENISCUS_HD inline bool in_piston(pbd::Phase phase) {
  return (phase & pbd::phase_piston) != 0;
}

/// Marks the particles in the table, and no others.
struct Mark {
  Table table;
  View<const uint32_t> slot;
  View<pbd::Phase> phase;

  MENISCUS_HD void operator()(uint32_t i) const {
    const bool is_in = table.find(slot[i]) != pbd::no_index;
    if (is_in != in_piston(phase[i])) phase[i] ^= pbd::phase_piston;
  }
};

/// Puts a particle where its velocity takes it: p = x + h v. What constraints did instead is an impulse on
/// the piston.
struct Place {
  Table table;
  View<const pbd::Phase> phase;
  View<const uint32_t> slot;
  View<const Vec4> previous;
  View<Vec4> position, accumulated_delta, velocity;
  View<float> impulse;  ///< N·s, of a substep, against the motion, by place in the table
  float dt;             ///< 0 while overlaps are relaxed
  bool starts;          ///< no constraint has acted yet

  MENISCUS_HD void operator()(uint32_t i) const {
    if (!in_piston(phase[i])) return;
    const uint32_t k = table.find(slot[i]);
    if (k == pbd::no_index) return;
    const Piston& piston = table.piston_of(k);
    const Vec4 x = previous[i];
    if (!starts && dt > 0) impulse[k] -= dot(accumulated_delta[i].xyz(), piston.direction()) / (x.w * dt);
    position[i] = pbd::with_w(x.xyz() + dt * piston.velocity, x.w);
    accumulated_delta[i] = {0, 0, 0, x.w};
    velocity[i] = pbd::with_w(piston.velocity, velocity[i].w);
  }
};

/// A contact too far away to act.
MENISCUS_HD inline pbd::Contact no_contact(Vec3 x, float h) {
  pbd::Contact c{};
  c.normal = {0, 1, 0};
  c.point = x - 1000 * h * c.normal;
  c.solid = c.body = pbd::no_index;
  return c;
}

/// The part of a piston's duct in the half-space behind its mouth, for a kernel of support radius h about q,
/// in the mouth's frame. As in solid_fraction() for the face of a box or a cylinder.
MENISCUS_HD inline float duct_part(const Piston& piston, Vec3 q, float h) {
  using namespace collision::detail;
  if (!piston.is_round) return slab_density(q.x, piston.half.x, h) * slab_density(q.z, piston.half.z, h);
  const float rho = sqrtf(q.x * q.x + q.z * q.z), radius = piston.half.x;
  return pbd::half_space_density((rho - radius) / h, 0.5f * h / radius);
}

/// Opens walls at mouths for the fluid. What a duct replaces of a wall has no mirror ghosts. The wall
/// still stops fluid at its contact radius, so that none enters the duct. Particles of pistons touch nothing.
struct OpenWalls {
  View<const Piston> pistons;
  View<const pbd::Phase> phase;
  View<const Vec4> position;
  pbd::ContactView contacts;
  float h;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 x = position[i].xyz();
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      pbd::Contact& c = contacts.contacts[k];
      if (c.solid == pbd::no_index) continue;
      if (in_piston(phase[i])) {
        c = no_contact(x, h);
      } else if (c.body == pbd::no_index) {
        for (uint32_t n = 0; n < pistons.count; ++n) open(pistons[n], x, c);
      }
    }
  }

  MENISCUS_HD void open(const Piston& piston, Vec3 x, pbd::Contact& c) const {
    const Vec3 on_wall = to_local(piston.mouth, c.point);
    const float facing = dot(c.normal, piston.direction());
    if (fabsf(on_wall.y) > h || !(facing > 0)) return;
    c.fraction *= 1 - facing * duct_part(piston, to_local(piston.mouth, x), h);
  }
};

/// The positional impulse, kg·m, of walls on particle i in front of a mouth, where a wall takes load off the
/// piston.
struct WallLoad {
  Piston piston;
  pbd::ContactView contacts;
  float h;

  MENISCUS_HD double operator()(uint32_t i) const {
    double load = 0;
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      const pbd::Contact& c = contacts.contacts[k];
      if (c.body != pbd::no_index || c.solid == pbd::no_index) continue;
      const Vec3 on_wall = to_local(piston.mouth, c.point);
      const float facing = dot(c.normal, piston.direction());
      if (fabsf(on_wall.y) <= h && facing > 0 && piston.holds(on_wall))
        load += double{c.normal_multiplier} * facing;
    }
    return load;
  }
};

/// The impulse of particle i on one piston in a substep, N·s: as a part of it, and through walls.
struct ImpulseOn {
  Table table;
  uint32_t piston;
  WallLoad walls;
  View<const pbd::Phase> phase;
  View<const uint32_t> slot;
  View<const float> impulse;
  float dt;

  MENISCUS_HD double operator()(uint32_t i) const {
    if (!in_piston(phase[i])) return walls(i) / double{dt};
    const uint32_t k = table.find(slot[i]);
    return k != pbd::no_index && table.particles[k].piston == piston ? double{impulse[k]} : 0;
  }
};

/// The sums of a piston's step. Exact ones have the same bits on any number of ranks.
struct PlainSums {
  double impulse = 0, error = 0;
  uint64_t ahead = 0;  ///< the particles of which `error` is the sum of C

  MENISCUS_HD PlainSums operator+(const PlainSums& b) const {
    return {impulse + b.impulse, error + b.error, ahead + b.ahead};
  }
};
struct ExactSums {
  pbd::ExactSum impulse, error;
  uint64_t ahead = 0;

  MENISCUS_HD ExactSums operator+(const ExactSums& b) const {
    return {impulse + b.impulse, error + b.error, ahead + b.ahead};
  }
};
MENISCUS_HD inline void set(double& sum, double value) {
  sum = value;
}
MENISCUS_HD inline void set(pbd::ExactSum& sum, double value) {
  sum = pbd::ExactSum::of(value);
}

template <class Sums>
struct Add {
  MENISCUS_HD Sums operator()(const Sums& a, const Sums& b) const { return a + b; }
};

/// Adds what a launch has found to the sums of a step.
template <class Sums>
struct Accumulate {
  View<const Sums> found;
  View<Sums> total;

  MENISCUS_HD void operator()(uint32_t k) const { total[k] = total[k] + found[k]; }
};

template <class Sums>
struct ImpulseSums {
  ImpulseOn impulse;

  MENISCUS_HD Sums operator()(uint32_t i) const {
    Sums sums;
    set(sums.impulse, impulse(i));
    return sums;
  }
};

/// The sum of C over the fluid in front of a mouth, up to h from the foremost layer.
template <class Sums>
struct Ahead {
  Piston piston;
  View<const Vec4> position;
  View<const uint32_t> place;
  View<const pbd::Phase> phase;
  View<const float> error;  ///< C, by place
  float h;

  MENISCUS_HD Sums operator()(uint32_t i) const {
    if (in_piston(phase[i]) || pbd::is_grain(phase[i])) return {};
    const Vec3 q = to_local(piston.mouth, position[i].xyz());
    if (q.y < 0 || q.y > piston.front + h || !piston.holds(q)) return {};
    Sums sums;
    set(sums.error, double{error[place[i]]});
    sums.ahead = 1;
    return sums;
  }
};

}  // namespace meniscus::piston_kernels
