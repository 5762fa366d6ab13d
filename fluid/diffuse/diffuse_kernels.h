// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels that create, advect and remove diffuse particles. diffuse.h has the equations.
#pragma once

#include "fluid/diffuse/diffuse.h"
#include "fluid/diffuse/tuning.h"
#include "fluid/kernel/kernel.h"
#include "pbd/math/random.h"
#include "pbd/neighbours.h"

namespace meniscus::fluid::diffuse_kernels {

using pbd::random_numbers;
using pbd::Vec3Of;
using pbd::Vec4;
using pbd::View;

/// Φ: rises from 0 to 1 over a range.
MENISCUS_HD inline float fraction_of(const Range& range, float value) {
  return pbd::clamp((value - range.low) / (range.high - range.low), 0, 1);
}

/// The outward normal of a particle at a surface, and its trapped air.
template <class D>
struct FindSurface {
  DiffuseParameters parameters;
  View<const Vec4> position, velocity;
  pbd::NeighbourView neighbours;
  View<Vec4> normal;

  MENISCUS_HD void operator()(uint32_t i) const {
    using Real = typename D::Real;
    const Vec3 x = position[i].xyz(), v = velocity[i].xyz();
    const float inverse_h = 1 / parameters.support;
    Vec3Of<Real> outward{Real(0.0f), Real(0.0f), Real(0.0f)};
    Real air{0.0f};
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const Vec3Of<Real> d = x - gather(position, j).xyz(), dv = v - gather(velocity, j).xyz();
      const Real r2 = dot(d, d) + Real(tiny_distance2), v2 = dot(dv, dv) + Real(tiny_distance2);
      const Real inverse_r = inverse_sqrt(r2);
      const Real w = max(Real(1.0f) - Real(inverse_h) * (r2 * inverse_r), Real(0.0f));
      outward += w * d;
      air += w * (v2 * inverse_sqrt(v2) - dot(dv, d) * inverse_r);
    });
    const Vec3 n = (inverse_h / parameters.full_weight) * sum(outward);
    const Vec3 unit = length(n) > diffuse_tuning::least_normal ? normalized_or(n, {0, 0, 0}) : Vec3{0, 0, 0};
    normal[i] = pbd::with_w(unit, sum(air) / parameters.full_weight);
  }
};

/// Where a fluid particle's births are counted: by slot, so that new particles have an order that does not
/// depend on places. In a shared world by index, as other ranks have other slots.
struct BirthPlaces {
  View<const uint32_t> slot;

  MENISCUS_HD uint32_t of(uint32_t i) const { return slot.count ? slot[i] : i; }
};

/// The number of diffuse particles that a fluid particle creates.
template <class D>
struct CountBirths {
  DiffuseParameters parameters;
  View<const Vec4> position, velocity, normal;
  pbd::NeighbourView neighbours;
  View<const pbd::Phase> phase;
  View<const uint32_t> number;
  uint32_t step;
  float dt;
  BirthPlaces places;
  View<uint32_t> born;

  MENISCUS_HD void operator()(uint32_t i) const {
    const DiffuseDef& def = parameters.def;
    const uint32_t place = places.of(i);
    born[place] = 0;
    const Vec3 v = velocity[i].xyz();
    const float energy = fraction_of(def.energy, 0.5f * dot(v, v));
    if (pbd::is_grain(phase[i]) || !(energy > 0)) return;
    const Vec4 self = normal[i];
    float rate = def.air_rate * fraction_of(def.air, self.w);
    if (dot(self.xyz(), v) > diffuse_tuning::crest_cosine * length(v))
      rate += def.crest_rate * fraction_of(def.crest, crest(i));
    const float n = pbd::min(rate * energy * dt, diffuse_tuning::most_births);
    const float whole = floorf(n);
    const float chance = random_numbers(number[i], step, 0).x;
    born[place] = static_cast<uint32_t>(whole) + (chance < n - whole);
  }

 private:
  MENISCUS_HD float crest(uint32_t i) const {
    using Real = typename D::Real;
    const Vec3 x = position[i].xyz(), n = normal[i].xyz();
    const float inverse_h = 1 / parameters.support;
    Real total{0.0f};
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const Vec3Of<Real> d = x - gather(position, j).xyz(), other = gather(normal, j).xyz();
      const Real r2 = dot(d, d) + Real(tiny_distance2);
      const Real w = max(Real(1.0f) - Real(inverse_h) * (r2 * inverse_sqrt(r2)), Real(0.0f));
      // Neighbours without a normal are inside the fluid, and do not describe the surface.
      const Real turned = dot(other, other) - dot(n, other);
      total += select_less(Real(0.0f), dot(n, d), w * turned, Real(0.0f));
    });
    return sum(total) / parameters.full_weight;
  }
};

/// The fluid around a diffuse particle.
struct Surroundings {
  float weight = 0;  ///< of fluid, 1 inside it
  Vec3 velocity{0, 0, 0};
};

/// Moves each particle according to its kind, and ages it.
struct Move {
  DiffuseParameters parameters;
  View<const Vec4> position, velocity;
  View<const pbd::Phase> phase;
  pbd::GridView grid;
  uint32_t fluid;  ///< number of fluid particles; without any the grid is not valid
  float dt;
  View<const DiffuseParticle> from;
  View<DiffuseParticle> to;

  MENISCUS_HD void operator()(uint32_t i) const {
    DiffuseParticle p = from[i];
    p.life -= dt;
    const Surroundings around = surroundings_at(p.position);
    const DiffuseDef& def = parameters.def;
    if (around.weight < def.spray_below) {
      p.kind = DiffuseKind::spray;
      p.velocity += dt * parameters.gravity;
    } else if (around.weight < def.bubbles_above) {
      p.kind = DiffuseKind::foam;
      p.velocity = around.velocity;
    } else {
      p.kind = DiffuseKind::bubble;
      const Vec3 risen = p.velocity - (dt * def.buoyancy) * parameters.gravity;
      p.velocity = around.velocity + expf(-def.drag * dt) * (risen - around.velocity);
    }
    p.position += dt * p.velocity;
    if (!is_finite(p.position) || !is_finite(p.velocity)) p.life = 0;
    to[i] = p;
  }

 private:
  MENISCUS_HD Surroundings surroundings_at(Vec3 at) const {
    Surroundings sum;
    const float h = parameters.support;
    if (fluid == 0) return sum;
    pbd::RunsAround(grid, at).for_each([&](uint32_t begin, uint32_t end) {
      for (uint32_t j = begin; j < end; ++j) {
        const Vec3 d = position[j].xyz() - at;
        const float r2 = dot(d, d);
        if (!(r2 < h * h) || pbd::is_grain(phase[j])) continue;
        const float w = 1 - sqrtf(r2) / h;
        sum.weight += w;
        sum.velocity += w * velocity[j].xyz();
      }
    });
    if (sum.weight > 0) sum.velocity = sum.velocity / sum.weight;
    sum.weight /= parameters.full_weight;
    return sum;
  }
};

struct MarkAlive {
  View<const DiffuseParticle> particles;
  View<uint32_t> alive;

  MENISCUS_HD void operator()(uint32_t i) const { alive[i] = particles[i].life > 0; }
};

/// Marks the particles that others have now. They are in the regions of these.
struct MarkHandedOver {
  View<const DiffuseParticle> before;
  pbd::GridView grid;
  View<uint32_t> alive;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 p = before[i].position;
    if (is_finite(p) && !grid.owns(grid.coordinates(p))) alive[i] = 0;
  }
};

template <class T>
struct KeepAlive {
  View<const T> from;
  View<const uint32_t> place;
  View<T> to;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (place[i + 1] != place[i]) to[place[i]] = from[i];
  }
};

/// Creates particles in a cylinder around the path of a fluid particle in the step (section 4.1).
struct MakeNew {
  DiffuseParameters parameters;
  View<const Vec4> position, velocity;
  View<const uint32_t> number, born_before, kept;  ///< kept: one element, the index at which new ones begin
  BirthPlaces places;
  uint32_t step;
  float dt;
  View<DiffuseParticle> to;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t place = places.of(i), first = kept[0] + born_before[place],
                   count = born_before[place + 1] - born_before[place];
    for (uint32_t k = 0; k < count && first + k < to.count; ++k) to[first + k] = one(i, k);
  }

 private:
  MENISCUS_HD DiffuseParticle one(uint32_t i, uint32_t k) const {
    const Vec3 v = velocity[i].xyz();
    const Vec3 along = normalized_or(v, {0, 1, 0});
    const Vec3 side =
        normalized_or(cross(along, fabsf(along.x) < 0.6f ? Vec3{1, 0, 0} : Vec3{0, 0, 1}), {1, 0, 0});
    const Vec3 other = cross(along, side);
    const Vec3 a = random_numbers(number[i], step, 2 * k + 1), b = random_numbers(number[i], step, 2 * k + 2);
    const float r = parameters.radius * sqrtf(a.x), angle = 6.2831853f * a.y;
    const Vec3 out = r * cosf(angle) * side + r * sinf(angle) * other;
    DiffuseParticle p{};
    p.position = position[i].xyz() + out + (a.z * length(v) * dt) * along;
    p.velocity = v + (parameters.def.spread * length(v) / parameters.radius) * out;
    const Range& life = parameters.def.lifetime;
    p.life = life.low + b.x * (life.high - life.low);
    p.kind = DiffuseKind::foam;
    return p;
  }
};

/// The keys of what MakeNew creates.
struct MakeKeys {
  View<const uint32_t> slot, born_before, kept;
  uint32_t step;
  View<DiffuseKey> to;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t first = kept[0] + born_before[i], count = born_before[i + 1] - born_before[i];
    for (uint32_t k = 0; k < count && first + k < to.count; ++k) to[first + k] = {step, slot[i], k};
  }
};

struct NoteTotals {
  View<const uint32_t> kept, born;  ///< one element each
  uint32_t capacity;
  View<uint32_t> totals;  ///< the present number, and the number beyond the capacity

  MENISCUS_HD void operator()(uint32_t) const {
    const uint32_t room = capacity - kept[0], refused = born[0] > room ? born[0] - room : 0;
    totals[0] = kept[0] + born[0] - refused;
    totals[1] = refused;
  }
};

}  // namespace meniscus::fluid::diffuse_kernels
