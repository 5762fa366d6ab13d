// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The narrow phase: from a pair of features to a contact, if it is one.
#pragma once

#include "cloth/self_contact/cull.h"
#include "cloth/self_contact/tuning.h"
#include "cloth/self_contact/views.h"

namespace meniscus::cloth::self_contact_kernels {

/// Nothing penetrates at the start of a substep, so that start gives the side of each contact. Where the
/// motion is small against the distance, the pair is tested at its predicted position. Otherwise it is tested
/// where it meets during the motion.
struct MakeContacts {
  ClothState cloth;
  View<const FeatureCode> candidate_list;
  View<const Vec3> rest;  // by vertex
  ContactList all_contacts;
  View<uint32_t> entries;  // by vertex: its number of contacts
  float separation;        // of a thickness: how much further overlaps are pushed apart in the substep
  uint32_t worlds;
  uint32_t stride;  // groups of threads for each world

  using Scratch = CullScratch;
  static constexpr uint32_t resident_blocks = 6;  ///< see CudaDevice

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    const uint32_t world = n / stride;
    const ContactList list = all_contacts.of(world, all_contacts.corners.count / worlds);
    const View<const FeatureCode> codes = part_of(candidate_list, world, candidate_list.count / worlds);
    if (list.counters[overflowed] != 0) return;
    Cull(listed(codes, list.counters[candidates]), n % stride, stride)
        .run(
            group, scratch, [&](uint32_t k) { return may_be_contact(load(codes, k)); },
            [&](uint32_t k) { make(list, load(codes, k)); });
  }

 private:
  /// A quick test, which few pairs pass.
  MENISCUS_HD bool may_be_contact(FeatureCode code) const {
    if (code.is_for_failsafe()) return false;
    const Corners corners = cloth.corners_of(code);
    const FeaturePair pair = pair_of(corners, cloth.previous, cloth.position);
    const float reach = reach_of(code);
    if (pbd::least_gap(pair) > reach) return false;
    const Nearest end = nearest(pair, 1);
    return relative_motion(pair) >= self_contact_tuning::fast_by_end * end.distance ||
           end.distance <= nearness_of(code) ||
           (end.distance <= reach && !is_another_pairs(code, corners, end));
  }

  MENISCUS_HD void make(const ContactList& list, FeatureCode code) const {
    const Corners corners = cloth.corners_of(code);
    const float thickness = thickness_of(code), reach = reach_of(code), near = nearness_of(code);
    const FeaturePair pair = pair_of(corners, cloth.previous, cloth.position);
    const float motion = relative_motion(pair), start = nearest(pair, 0).distance;
    if (start - motion > reach || start < self_contact_tuning::coincident * thickness) return;
    const bool fast = motion >= self_contact_tuning::fast * start;
    const float t =
        fast ? time_of_nearness(pair, self_contact_tuning::meeting * pbd::min(start, thickness)) : 2;
    const bool met = t <= 1;
    const Nearest now = nearest(pair, met ? t : 1);
    const bool is_near = met || pbd::min(start, now.distance) < near ||
                         (fast && start < self_contact_tuning::near_when_fast * near);
    if (!is_near && (now.distance > reach || is_another_pairs(code, corners, now))) return;
    const float apart = distance_to_keep(code, corners, thickness);
    if (apart <= 0 || now.distance <= 0) return;
    if (!is_near && now.distance > apart + self_contact_tuning::margin * thickness) return;
    const float target = pbd::min(apart, start + separation * thickness);
    add(list, corners, now, target, friction_of(code));
  }

  MENISCUS_HD const PieceProperties& first_piece(FeatureCode code) const {
    return piece_at(code.first_place());
  }
  MENISCUS_HD const PieceProperties& second_piece(FeatureCode code) const {
    return piece_at(code.second_place());
  }
  MENISCUS_HD const PieceProperties& piece_at(uint32_t place) const {
    return cloth.pieces[cloth.tree.triangles[place].piece];
  }
  MENISCUS_HD float thickness_of(FeatureCode code) const {
    return 0.5f * (first_piece(code).thickness + second_piece(code).thickness);
  }
  /// The distance beyond which two features count as apart.
  MENISCUS_HD float reach_of(FeatureCode code) const {
    return self_contact_tuning::reach * thickness_of(code);
  }
  /// Any pair that comes nearer than this during its motion is a contact.
  MENISCUS_HD float nearness_of(FeatureCode code) const {
    return first_piece(code).nearness + second_piece(code).nearness;
  }
  MENISCUS_HD float friction_of(FeatureCode code) const {
    return sqrtf(first_piece(code).friction * second_piece(code).friction);
  }

  /// Whether the nearest point also belongs to another pair of features. That is an end of one of two edges,
  /// or an edge or corner that the triangle does not own.
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

  /// Features that are nearer than the thickness at rest, as in a fine mesh, are not pushed apart.
  MENISCUS_HD float distance_to_keep(FeatureCode code, const Corners& corners, float thickness) const {
    if (cloth.tree.triangles[code.first_place()].piece != cloth.tree.triangles[code.second_place()].piece)
      return thickness;
    FeaturePair at_rest{};
    at_rest.edges = corners.edges();
    for (uint32_t k = 0; k < 4; ++k) at_rest.start[k] = rest[corners.vertex(k)] - rest[corners.vertex(0)];
    return pbd::min(thickness, self_contact_tuning::kept_of_rest * nearest(at_rest, 0).distance);
  }

  MENISCUS_HD void add(const ContactList& list, const Corners& corners, const Nearest& now, float target,
                       float friction) const {
    const uint32_t c = pbd::append(list.counters[contacts], 1);
    if (cloth.frames.differ(corners.vertex(0), corners.vertex(3)))
      pbd::atomic_max(list.counters[frames_meet], 1);
    if (c >= list.corners.count) return;
    list.corners[c] = corners;
    list.plane[c] = pbd::with_w(now.r / now.distance, target);
    list.multiplier[c] = {0, 0, 0, 0};
    list.weights[c] = {now.u, now.v, friction};
    for (uint32_t k = 0; k < 4; ++k) pbd::atomic_add(entries[corners.vertex(k)], 1);
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
