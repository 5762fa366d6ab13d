// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The solve of cloth-to-cloth contacts: contacts push, then vertices move by what pushes them.
#pragma once

#include "cloth/self_contacts_views.h"
#include "pbd/device/atomics.h"

namespace meniscus::cloth::self_contact_kernels {

/// Enters each contact with its four vertices.
struct EnterContacts {
  ContactList list;
  View<const uint32_t> start;
  View<uint32_t> left;     // by vertex: entries still to come; 0 in the end
  View<uint32_t> entries;  // contact, and its corner in the lowest two bits

  MENISCUS_HD void operator()(uint32_t c) const {
    if (c >= list.count()) return;
    for (uint32_t k = 0; k < 4; ++k) {
      const uint32_t v = list.corners[c].vertex(k);
      const uint32_t at = start[v] + pbd::atomic_add(left[v], ~0u) - 1;
      if (at < entries.count) entries[at] = c << 2 | k;
    }
  }
};

/// C = n·r − d ≥ 0 with r = Σ weight · x, and Coulomb's friction (Macklin et al. 2014, eqs. 23 and 24): the
/// slip of the substep is taken back up to μ times the normal push. Both multipliers are accumulated. All
/// contacts act at once; a vertex with k contacts lends 1/k of its mass to each (mass splitting, Tonge,
/// Benevolenski & Voroshilov 2012), so that together they push no more than there is to push.
struct PushApart {
  ContactList list;
  View<const Vec4> position, previous;  // by vertex
  View<const uint32_t> start;

  MENISCUS_HD void operator()(uint32_t c) const {
    if (c >= list.count()) return;
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
      give += static_cast<float>(start[v + 1] - start[v]) * x.w * weight[k] * weight[k];
    }
    const float distance = list.push[c].w;
    list.push[c] = pbd::with_w(give > 0 ? push(c, r, slip, give, w.friction) : Vec3{0, 0, 0}, distance);
  }

  /// What it adds, kg·m.
  MENISCUS_HD Vec3 push(uint32_t c, Vec3 r, Vec3 slip, float give, float friction) const {
    const Vec4 plane = list.plane[c], old = list.multiplier[c];
    const Vec3 n = plane.xyz();
    const float normal = pbd::max(0, old.w - (dot(n, r) - plane.w) / give);
    if (normal == 0 && old.w == 0) return {0, 0, 0};
    Vec3 tangent = old.xyz() - (slip - dot(slip, n) * n) / give;
    const float most = friction * normal, size = length(tangent);
    if (size > most) tangent = (most / size) * tangent;
    list.multiplier[c] = pbd::with_w(tangent, normal);
    return (normal - old.w) * n + (tangent - old.xyz());
  }
};

/// Sums what pushes a vertex in integers, whose sum is the same in any order, and moves it.
struct MoveVertices {
  ContactList list;
  View<const uint32_t> start, entries;
  View<Vec4> position, moved;  // by vertex
  float unit;                  // kg·m, of the integers; a power of 2

  MENISCUS_HD void operator()(uint32_t v) const {
    const uint32_t begin = start[v], end = start[v + 1] < entries.count ? start[v + 1] : entries.count;
    if (begin >= end) return;
    const Vec4 x = position[v];
    if (x.w == 0) return;
    int64_t sum[3] = {0, 0, 0};
    for (uint32_t e = begin; e < end; ++e) add(entries[e] >> 2, entries[e] & 3, sum);
    const Vec3 step = x.w * Vec3{unit * static_cast<float>(sum[0]), unit * static_cast<float>(sum[1]),
                                 unit * static_cast<float>(sum[2])};
    position[v] = pbd::with_w(x.xyz() + step, x.w);
    moved[v] = pbd::with_w(moved[v].xyz() + step, moved[v].w);
  }

  MENISCUS_HD void add(uint32_t c, uint32_t k, int64_t (&sum)[3]) const {
    const Vec3 push = list.push[c].xyz();
    if (push == Vec3{0, 0, 0}) return;
    const ContactWeights w = list.weights[c];
    float weight[4];
    corner_weights(list.corners[c].edges(), w.u, w.v, weight);
    const Vec3 whole = (weight[k] / unit) * push;
    sum[0] += llrintf(whole.x);
    sum[1] += llrintf(whole.y);
    sum[2] += llrintf(whole.z);
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
