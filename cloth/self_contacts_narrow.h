// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// From a pair of features to a contact, if it is one.
#pragma once

#include "cloth/self_contacts_views.h"

namespace meniscus::cloth::self_contact_kernels {

/// Nothing penetrates at the substep's start, so that the side is known from there. Where the motion is short
/// for the distance, the pair is looked at where it is predicted to be; else where it meets on the way.
struct MakeContacts {
  ClothState cloth;
  View<const FeatureCode> candidate_list;
  View<const Vec3> rest;  // by vertex
  ContactList list;
  View<uint32_t> entries;  // by vertex: its number of contacts
  float separation;        // of a thickness: how much further apart overlaps are pushed in the substep
  uint32_t stride;

  MENISCUS_HD void operator()(uint32_t thread) const {
    if (list.counters[doomed] != 0) return;
    const uint32_t count = listed(candidate_list, list.counters[candidates]);
    for (uint32_t n = thread; n < count; n += stride) {
      const FeatureCode code = load(candidate_list, n);
      if (!code.is_guards()) make(code);
    }
  }

  MENISCUS_HD void make(FeatureCode code) const {
    const Corners corners = cloth.corners_of(code);
    const Part a = part_of(code.first_place()), b = part_of(code.second_place());
    const float thickness = 0.5f * (a.thickness + b.thickness), reach = 1.1f * thickness;

    const FeaturePair pair = pair_of(corners, cloth.previous, cloth.position);
    if (pbd::least_gap(pair) > reach) return;
    const float motion = relative_motion(pair);
    const Nearest end = nearest(pair, 1);
    // Whatever comes nearer than this on its way is a contact in any case.
    const float near = a.nearness + b.nearness;
    if (motion < 0.3f * end.distance && end.distance > near &&
        (end.distance > reach || is_another_pairs(code, corners, end)))
      return;
    const float start = nearest(pair, 0).distance;
    if (start - motion > reach || start < 1e-5f * thickness) return;
    const bool fast = motion >= 0.5f * start;
    const float t = fast ? time_of_nearness(pair, 0.5f * pbd::min(start, thickness)) : 2;
    const bool met = t <= 1;
    const Nearest now = met ? nearest(pair, t) : end;
    const bool is_near = met || pbd::min(start, now.distance) < near || (fast && start < 1.8f * near);
    if (!is_near && (now.distance > reach || is_another_pairs(code, corners, now))) return;
    const float apart = distance_to_keep(code, corners, thickness);
    if (apart <= 0 || now.distance <= 0) return;
    if (!is_near && now.distance > apart + 0.1f * thickness) return;
    const float target = pbd::min(apart, start + separation * thickness);
    add(corners, now, target, sqrtf(a.friction * b.friction));
  }

  MENISCUS_HD Part part_of(uint32_t place) const { return cloth.parts[cloth.tree.triangles[place].part]; }

  /// Whether the nearest place is one that another pair of features has as well: of two edges an end, of a
  /// triangle an edge or a corner that is not its own.
  MENISCUS_HD bool is_another_pairs(FeatureCode code, const Corners& corners, const Nearest& now) const {
    if (corners.edges()) return now.on != 15;
    const uint32_t owned = cloth.features[code.second_place()];
    switch (now.on) {
      case 7:
        return false;
      case 1:
        return !(owned & owns_vertex);
      case 2:
        return !(owned & owns_vertex << 1);
      case 4:
        return !(owned & owns_vertex << 2);
      case 3:
        return !(owned & owns_edge);
      case 6:
        return !(owned & owns_edge << 1);
      default:
        return !(owned & owns_edge << 2);
    }
  }

  /// What is nearer than the thickness at rest, as in a fine mesh, is not pushed apart.
  MENISCUS_HD float distance_to_keep(FeatureCode code, const Corners& corners, float thickness) const {
    if (cloth.tree.triangles[code.first_place()].part != cloth.tree.triangles[code.second_place()].part)
      return thickness;
    FeaturePair at_rest{};
    at_rest.edges = corners.edges();
    for (uint32_t k = 0; k < 4; ++k) at_rest.start[k] = rest[corners.vertex(k)] - rest[corners.vertex(0)];
    return pbd::min(thickness, 0.7f * nearest(at_rest, 0).distance);
  }

  MENISCUS_HD void add(const Corners& corners, const Nearest& now, float target, float friction) const {
    const uint32_t c = pbd::append(list.counters[contacts], 1);
    if (c >= list.corners.count) return;
    list.corners[c] = corners;
    list.plane[c] = pbd::with_w(now.r / now.distance, target);
    list.multiplier[c] = {0, 0, 0, 0};
    list.weights[c] = {now.u, now.v, friction};
    for (uint32_t k = 0; k < 4; ++k) pbd::atomic_add(entries[corners.vertex(k)], 1);
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
