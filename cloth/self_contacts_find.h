// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// From pairs of groups to pairs of features that may touch.
#pragma once

#include "cloth/self_contacts_keep.h"

namespace meniscus::cloth::self_contact_kernels {

/// Pairs of features of two triangles, by number: six of a vertex and a face, then nine of edges.
struct PairsOfTwo {
  static constexpr uint32_t most = 15;

  uint32_t place, other;  ///< of the triangles
  uint32_t mask = 0;      ///< of those that there are
  uint32_t guards = 0;    ///< and that become no contacts

  MENISCUS_HD FeatureCode code(uint32_t k) const {
    if (k < 3) return {feature(place, k), feature(other, face)};
    if (k < 6) return {feature(other, k - 3), feature(place, face)};
    const uint32_t e = (k - 6) / 3, f = (k - 6) % 3;
    return {feature(place, 3 + e) | (guards >> k & 1 ? FeatureCode::guard_bit : 0), feature(other, 3 + f)};
  }
  /// Calls visit(code) for each.
  template <class Visit>
  MENISCUS_HD void for_each(const Visit& visit) const {
    for (uint32_t left = mask; left != 0; left &= left - 1) visit(code(pbd::lowest_bit(left)));
  }
};

/// Pairs of features, of which each triangle shows those that it owns.
struct FeaturePairs {
  ClothState cloth;

  /// Bits of those of a group whose boxes overlap that of the triangle at `place`; of its own group the later
  /// ones.
  MENISCUS_HD uint32_t overlapping(uint32_t place, uint32_t other) const {
    const uint32_t mask = overlap_mask(cloth.tree.group(0, other), cloth.tree.box(0, place));
    return other == place / 8 ? mask & ~((2u << place % 8) - 1) : mask;
  }

  /// All that share no vertex. Edges that are neither on a border nor in a rough group are the guard's alone.
  MENISCUS_HD PairsOfTwo of_two(uint32_t place, uint32_t other) const {
    PairsOfTwo pairs{place, other};
    const Own a(*this, place), b(*this, other);
    MENISCUS_UNROLL
    for (uint32_t k = 0; k < 3; ++k) {
      if (a.has_vertex(k) && !has_vertex(b.triangle, corner_of(a.triangle, k))) pairs.mask |= 1u << k;
      if (b.has_vertex(k) && !has_vertex(a.triangle, corner_of(b.triangle, k))) pairs.mask |= 8u << k;
    }
    MENISCUS_UNROLL
    for (uint32_t k = 0; k < 9; ++k) {
      const uint32_t e = k / 3, f = k % 3;
      if (!a.has_edge(e) || !b.has_edge(f) || a.shares_end(e, b, f)) continue;
      pairs.mask |= 64u << k;
      if (!(a.shows_edge(e) && b.shows_edge(f))) pairs.guards |= 64u << k;
    }
    return pairs;
  }

  /// Whether the boxes of both overlap.
  MENISCUS_HD bool have_boxes_in_touch(FeatureCode code) const {
    const Corners corners = cloth.corners_of(code);
    const Aabb first = cloth.kept.box(corners.vertex(0)), second = cloth.kept.box(corners.vertex(1)),
               third = cloth.kept.box(corners.vertex(2)), fourth = cloth.kept.box(corners.vertex(3));
    const Aabb last = joined(third, fourth);
    return corners.edges() ? overlap(joined(first, second), last) : overlap(first, joined(second, last));
  }

 private:
  /// A triangle with the features that it owns, and those edges that are not the guard's alone.
  struct Own {
    uint32_t features, shown;
    SurfaceTriangle triangle;

    MENISCUS_HD Own(const FeaturePairs& pairs, uint32_t place)
        : features(pairs.cloth.features[place]),
          shown(pairs.cloth.rough[place / 8] ? features : features / is_border * owns_edge),
          triangle(load(pairs.cloth.tree.triangles, place)) {}

    MENISCUS_HD bool has_vertex(uint32_t k) const { return (features & uint32_t{owns_vertex} << k) != 0; }
    MENISCUS_HD bool has_edge(uint32_t k) const { return (features & uint32_t{owns_edge} << k) != 0; }
    MENISCUS_HD bool shows_edge(uint32_t k) const { return (shown & uint32_t{owns_edge} << k) != 0; }
    MENISCUS_HD bool shares_end(uint32_t e, const Own& other, uint32_t f) const {
      const uint32_t v = corner_of(triangle, e), w = corner_of(triangle, e < 2 ? e + 1 : 0),
                     s = corner_of(other.triangle, f), t = corner_of(other.triangle, f < 2 ? f + 1 : 0);
      return s == v || s == w || t == v || t == w;
    }
  };
};

/// Pairs of groups while a group of threads looks through them: pairs of triangles whose boxes overlap, by
/// number; those of them that no plane parts; pairs of features of some of these; and, by number, those whose
/// boxes overlap.
struct CandidateScratch {
  static constexpr uint32_t pairs = 16, at_once = 128, most_codes = 1024;

  uint16_t hits[64 * pairs], near[64 * pairs], touching[most_codes];
  FeatureCode codes[most_codes];
  uint32_t hit_count, near_count, code_count, touching_count;
};

/// Lists the pairs of features that may come near one another while their vertices stay where they are to, of
/// a number of pairs of groups at a time. Each step leaves few of what the one before has found, and all
/// threads share what is left.
struct FindCandidates {
  using Scratch = CandidateScratch;

  Listing listing;
  FeaturePairs features;
  GroupPairs pairs;
  View<FeatureCode> candidate_list;
  uint32_t stride;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    if (!listing.wanted()) return;
    const uint32_t count = pairs.count();
    for (uint32_t first = Scratch::pairs * n; first < count; first += Scratch::pairs * stride) {
      const uint32_t left = count - first < Scratch::pairs ? count - first : Scratch::pairs;
      group.for_each(1, [&](uint32_t) { scratch.hit_count = scratch.near_count = 0; });
      group.for_each(8 * left, [&](uint32_t k) { find_overlaps(scratch, pairs.list[first + k / 8], k); });
      group.for_each(scratch.hit_count, [&](uint32_t k) {
        const uint16_t hit = scratch.hits[k];
        if (!are_parted(places(first, hit))) scratch.near[pbd::atomic_add(scratch.near_count, 1)] = hit;
      });
      const uint32_t near = scratch.near_count;
      for (uint32_t done = 0; done < near; done += Scratch::at_once) {
        const uint32_t now = near - done < Scratch::at_once ? near - done : Scratch::at_once;
        group.for_each(1, [&](uint32_t) { scratch.code_count = scratch.touching_count = 0; });
        group.for_each(now,
                       [&](uint32_t k) { find_features(scratch, places(first, scratch.near[done + k])); });
        const uint32_t found = scratch.code_count;
        group.for_each(found < Scratch::most_codes ? found : Scratch::most_codes, [&](uint32_t k) {
          if (features.have_boxes_in_touch(scratch.codes[k]))
            scratch.touching[pbd::append(scratch.touching_count, 1)] = static_cast<uint16_t>(k);
        });
        group.for_each(scratch.touching_count, [&](uint32_t k) { list(scratch.codes[scratch.touching[k]]); });
      }
    }
  }

 private:
  MENISCUS_HD GroupPair places(uint32_t first, uint32_t k) const {
    return places_of(pairs.list[first + k / 64], k % 64);
  }
  MENISCUS_HD void find_overlaps(Scratch& scratch, GroupPair pair, uint32_t k) const {
    uint32_t mask = features.overlapping(8 * pair.first + k % 8, pair.second);
    for (; mask != 0; mask &= mask - 1)
      scratch.hits[pbd::atomic_add(scratch.hit_count, 1)] =
          static_cast<uint16_t>(8 * k + pbd::lowest_bit(mask));
  }
  MENISCUS_HD void find_features(Scratch& scratch, GroupPair two) const {
    const PairsOfTwo found = features.of_two(two.first, two.second);
    uint32_t place = pbd::append(scratch.code_count, pbd::bit_count(found.mask));
    found.for_each([&](FeatureCode code) {
      if (place < Scratch::most_codes)
        scratch.codes[place++] = code;
      else if (features.have_boxes_in_touch(code))
        list(code);
    });
  }
  MENISCUS_HD void list(FeatureCode code) const {
    if (!may_come_near(features.cloth.corners_of(code))) return;
    const uint32_t place = pbd::append(pairs.counters[candidates], 1);
    if (place < candidate_list.count) candidate_list[place] = code;
  }

  MENISCUS_HD Vec4 ball(uint32_t v) const { return load(features.cloth.kept.balls, v); }

  /// A triangle between the centres of its vertices' balls, seen from an origin.
  struct Middle {
    Vec3 corner[3];
    float radius = 0;

    MENISCUS_HD Vec3 normal() const { return cross(corner[1] - corner[0], corner[2] - corner[0]); }
    MENISCUS_HD Vec3 centre() const { return (1.0f / 3) * (corner[0] + corner[1] + corner[2]); }
    MENISCUS_HD float least(Vec3 n) const {
      return pbd::min(dot(n, corner[0]), pbd::min(dot(n, corner[1]), dot(n, corner[2])));
    }
    MENISCUS_HD float most(Vec3 n) const {
      return pbd::max(dot(n, corner[0]), pbd::max(dot(n, corner[1]), dot(n, corner[2])));
    }
  };
  MENISCUS_HD Middle middle(const SurfaceTriangle& t, Vec3 origin) const {
    Middle m;
    for (uint32_t k = 0; k < 3; ++k) {
      const Vec4 b = ball(corner_of(t, k));
      m.corner[k] = b.xyz() - origin;
      m.radius = pbd::max(m.radius, b.w);
    }
    return m;
  }
  /// Whether a plane across the way from one to the other, or along one of them, keeps them apart.
  MENISCUS_HD bool are_parted(GroupPair two) const {
    const SurfaceTriangle s = load(features.cloth.tree.triangles, two.first),
                          t = load(features.cloth.tree.triangles, two.second);
    if (has_vertex(t, s.a) || has_vertex(t, s.b) || has_vertex(t, s.c)) return false;
    const Vec3 origin = ball(s.a).xyz();
    const Middle a = middle(s, origin), b = middle(t, origin);
    const float reach = a.radius + b.radius;
    const auto parts = [&](Vec3 n) {
      return pbd::max(a.least(n) - b.most(n), b.least(n) - a.most(n)) > reach * length(n);
    };
    return parts(a.centre() - b.centre()) || parts(a.normal()) || parts(b.normal());
  }

  /// No point of either leaves the place that its corners are in by more than the greatest of their radii.
  MENISCUS_HD bool may_come_near(const Corners& corners) const {
    const Vec3 origin = ball(corners.vertex(0)).xyz();
    const uint32_t first = corners.edges() ? 2 : 1;
    FeaturePair pair{};
    pair.edges = corners.edges();
    float radius = 0, other_radius = 0;
    MENISCUS_UNROLL
    for (uint32_t k = 0; k < 4; ++k) {
      const Vec4 b = ball(corners.vertex(k));
      pair.start[k] = b.xyz() - origin;
      (k < first ? radius : other_radius) = pbd::max(k < first ? radius : other_radius, b.w);
    }
    return nearest(pair, 0).distance <= radius + other_radius;
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
