// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The solve of cloth-to-cloth contacts: contacts push, then vertices move by the sums of their pushes.
#pragma once

#include "cloth/self_contact/views.h"
#include "pbd/math/units.h"

namespace meniscus::cloth::self_contact_kernels {

/// The pushes on vertices, as three integers each. These have the same sum in any order.
struct PushSums {
  View<int64_t> sums;
  float unit;  // kg·m, of the integers; a power of 2

  MENISCUS_HD void add(uint32_t v, Vec3 push) const {
    const Vec3 whole = (1 / unit) * push;
    pbd::atomic_add(sums[3 * v], pbd::whole_units(whole.x));
    pbd::atomic_add(sums[3 * v + 1], pbd::whole_units(whole.y));
    pbd::atomic_add(sums[3 * v + 2], pbd::whole_units(whole.z));
  }
  /// The sum, kg·m.
  MENISCUS_HD Vec3 of(uint32_t v) const {
    return unit * Vec3{static_cast<float>(sums[3 * v]), static_cast<float>(sums[3 * v + 1]),
                       static_cast<float>(sums[3 * v + 2])};
  }
  /// The sum, kg·m; resets it to 0.
  MENISCUS_HD Vec3 take(uint32_t v) const {
    return unit * Vec3{take_one(sums[3 * v]), take_one(sums[3 * v + 1]), take_one(sums[3 * v + 2])};
  }

 private:
  MENISCUS_HD static float take_one(int64_t& sum) {
    const auto taken = static_cast<float>(sum);
    if (taken != 0) sum = 0;
    return taken;
  }
};

/// C = n·r − d ≥ 0 with r = Σ weight · x, and Coulomb's friction (Macklin et al. 2014, eqs. 23 and 24): the
/// slip of the substep is reversed, by up to μ times the normal push. Both multipliers are accumulated. All
/// contacts act at once. A vertex with k contacts gives 1/k of its mass to each (mass splitting, Tonge,
/// Benevolenski & Voroshilov 2012). So together they do not push too far.
struct PushApart {
  ContactList all_contacts;
  View<const Vec4> position, previous;  // by vertex
  View<const uint32_t> entries;         // by vertex: its number of contacts
  PushSums sums;
  uint32_t worlds;
  uint32_t stride;  // threads for each world

  MENISCUS_HD void operator()(uint32_t thread) const {
    const ContactList list = all_contacts.of(thread / stride, all_contacts.corners.count / worlds);
    const uint32_t count = list.count();
    for (uint32_t c = thread % stride; c < count; c += stride) solve(list, c);
  }

  MENISCUS_HD void solve(const ContactList& list, uint32_t c) const {
    const Corners corners = list.corners[c];
    const ContactWeights w = list.weights[c];
    float weight[4];
    corner_weights(corners.edges(), w.u, w.v, weight);
    const Vec3 origin = position[corners.vertex(0)].xyz();
    Vec3 r{0, 0, 0}, slip{0, 0, 0};
    float give = 0;
    for (uint32_t k = 0; k < 4; ++k) {
      const uint32_t v = corners.vertex(k);
      const Vec4 x = position[v];
      r += weight[k] * (x.xyz() - origin);
      slip += weight[k] * (x.xyz() - previous[v].xyz());
      give += static_cast<float>(entries[v]) * x.w * weight[k] * weight[k];
    }
    if (!(give > 0)) return;
    const Vec3 added = push(list, c, r, slip, give, w.friction);
    if (added == Vec3{0, 0, 0}) return;
    for (uint32_t k = 0; k < 4; ++k) sums.add(corners.vertex(k), weight[k] * added);
  }

  /// The increment of the contact's push, kg·m.
  MENISCUS_HD static Vec3 push(const ContactList& list, uint32_t c, Vec3 r, Vec3 slip, float give,
                               float friction) {
    const Vec4 plane = list.plane[c], old = list.multiplier[c];
    const Vec3 n = plane.xyz();
    const float normal = pbd::max(0, old.w - (dot(n, r) - plane.w) / give);
    if (normal == 0 && old.w == 0) return {0, 0, 0};
    const Vec3 tangent = shortened_to(old.xyz() - (slip - dot(slip, n) * n) / give, friction * normal);
    list.multiplier[c] = pbd::with_w(tangent, normal);
    return (normal - old.w) * n + (tangent - old.xyz());
  }
};

/// Moves vertices by the sums of their pushes.
struct MoveVertices {
  View<const uint32_t> entries;  // by vertex
  View<Vec4> position, accumulated_delta;
  PushSums sums;

  MENISCUS_HD void operator()(uint32_t v) const {
    if (entries[v] == 0) return;
    const Vec3 push = sums.take(v);
    const Vec4 x = position[v];
    if (x.w == 0 || push == Vec3{0, 0, 0}) return;
    const Vec3 step = x.w * push;
    position[v] = pbd::with_w(x.xyz() + step, x.w);
    accumulated_delta[v] = pbd::shifted(accumulated_delta[v], step);
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
