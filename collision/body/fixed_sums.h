// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of body_set.inl for fixed sums: sums over a body's contacts in integers, which have the same
// bits for any order of the contacts.
#pragma once

#include "collision/body/body_kernels.h"
#include "pbd/math/units.h"

namespace meniscus::collision::body_kernels {

/// A ContactSum in a body's units.
struct IntegerSum {
  int64_t push[3], twist[3];
  uint64_t overflows;  ///< how often a value or a sum had no room

  MENISCUS_HD void add(const IntegerSum& other) {
    overflows += other.overflows;
    for (int k = 0; k < 3; ++k) {
      push[k] = sum_of(push[k], other.push[k]);
      twist[k] = sum_of(twist[k], other.twist[k]);
    }
  }

 private:
  /// Wraps around where it overflows, and notes that.
  MENISCUS_HD int64_t sum_of(int64_t a, int64_t b) {
    const uint64_t x = static_cast<uint64_t>(a), y = static_cast<uint64_t>(b), sum = x + y;
    overflows += ((x ^ sum) & (y ^ sum)) >> 63;
    return static_cast<int64_t>(sum);
  }
};

/// The units of a body's sums, powers of 2. They follow from the body alone.
struct SumUnits {
  float push;   ///< kg·m
  float twist;  ///< kg·m²
};

/// The power of 2 that x, normal and above 0, reaches.
MENISCUS_HD inline float power_below(float x) {
  int exponent = 0;
  frexpf(x, &exponent);
  return ldexpf(1.0f, exponent - 1);
}

/// A contact that moves the whole body by 2⁻⁴⁴ m counts one unit. A body that nothing moves counts as water.
MENISCUS_HD inline SumUnits units_of(const BodyProxy& body, float reach) {
  constexpr float water = 1000;  // kg/m³
  const float arm = power_below(pbd::max(reach, 1e-6f));
  const float mass = body.inverse_mass > 0 ? 1 / body.inverse_mass : water * arm * arm * arm;
  const float push = 0x1p-44f * power_below(pbd::max(mass, 1e-16f));
  return {push, push * arm};
}

/// Sums one lane of one body.
struct SumLanesInIntegers {
  View<const uint32_t> grouped;
  View<const BodyProxy> bodies;
  View<const float> reaches;
  View<const Contact> contacts;
  View<IntegerSum> partial;
  uint32_t lanes;

  MENISCUS_HD void operator()(uint32_t n) const {
    const BodyProxy& body = bodies[n / lanes];
    const SumUnits unit = units_of(body, reaches[n / lanes]);
    IntegerSum sum{};
    for (uint32_t k = body.first + n % lanes; k < body.end; k += lanes) {
      const Contact& c = contacts[grouped[k]];
      const Vec3 push = multiplier_sum(c);
      sum.add(in_units(push, cross(c.arm, push), unit));
    }
    partial[n] = sum;
  }

 private:
  MENISCUS_HD static IntegerSum in_units(Vec3 push, Vec3 twist, const SumUnits& unit) {
    const Vec3 p = (1 / unit.push) * push, t = (1 / unit.twist) * twist;
    return {{pbd::whole_units(p.x), pbd::whole_units(p.y), pbd::whole_units(p.z)},
            {pbd::whole_units(t.x), pbd::whole_units(t.y), pbd::whole_units(t.z)},
            beyond(p) + beyond(t)};
  }
  /// What whole_units() cuts off. Values that are not finite fail the step in another way.
  MENISCUS_HD static uint64_t beyond(Vec3 v) {
    constexpr float most = 0x1p52f;
    return fabsf(v.x) >= most || fabsf(v.y) >= most || fabsf(v.z) >= most;
  }
};

/// A body's sum in integers.
MENISCUS_HD inline IntegerSum total_of(View<const IntegerSum> partial, uint32_t body, uint32_t parts) {
  IntegerSum sum{};
  for (uint32_t k = 0; k < parts; ++k) sum.add(partial[body * parts + k]);
  return sum;
}

/// Writes it alone, for the ranks of a shared world.
struct AddLanes {
  View<const IntegerSum> from;
  View<IntegerSum> totals;
  uint32_t lanes;

  MENISCUS_HD void operator()(uint32_t b) const { totals[b] = total_of(from, b, lanes); }
};

/// Writes a body's sum to the first of its lanes, and 0 to the others.
struct FoldLanes {
  View<const BodyProxy> bodies;
  View<const float> reaches;
  View<const IntegerSum> from;
  View<ContactSum> to;
  uint32_t parts, lanes;  ///< of a body, in `from` and `to`

  MENISCUS_HD void operator()(uint32_t b) const {
    const IntegerSum sum = total_of(from, b, parts);
    for (uint32_t k = 0; k < lanes; ++k) to[b * lanes + k] = {};
    const SumUnits unit = units_of(bodies[b], reaches[b]);
    to[b * lanes].add(vector(sum.push, unit.push), vector(sum.twist, unit.twist));
  }

 private:
  MENISCUS_HD static Vec3 vector(const int64_t (&sum)[3], float unit) {
    return {unit * static_cast<float>(sum[0]), unit * static_cast<float>(sum[1]),
            unit * static_cast<float>(sum[2])};
  }
};

}  // namespace meniscus::collision::body_kernels
