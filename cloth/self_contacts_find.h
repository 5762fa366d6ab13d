// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// From pairs of groups to pairs of features that may touch.
#pragma once

#include "cloth/self_contacts_keep.h"

namespace meniscus::cloth::self_contact_kernels {

/// Pairs of features, of which each triangle shows those that it owns.
struct FeaturePairs {
  ClothState cloth;

  /// Bits of those of a group whose boxes overlap that of the triangle at `place`; of its own group the later
  /// ones.
  MENISCUS_HD uint32_t overlapping(uint32_t place, uint32_t other) const {
    const uint32_t mask = overlap_mask(cloth.tree.group(0, other), cloth.tree.box(0, place));
    return other == place / 8 ? mask & ~((2u << place % 8) - 1) : mask;
  }
  /// Calls visit(code) for each whose boxes overlap. Edges that are neither on a border nor in a rough group
  /// are the guard's alone.
  template <class Visit>
  MENISCUS_HD void of_two(uint32_t place, uint32_t other, const Visit& visit) const {
    const Own own(*this, place), of_other(*this, other);
    vertices(own, of_other, visit);
    vertices(of_other, own, visit);
    edges(own, of_other, visit);
  }

 private:
  MENISCUS_HD uint32_t shown(uint32_t place, uint32_t features) const {
    if (cloth.rough[place / 8]) return features;
    return (features & ~(7u * owns_edge)) | features / is_border * owns_edge;
  }

  /// A triangle with the boxes of its vertices.
  struct Own {
    uint32_t place, features, shown;
    SurfaceTriangle triangle;
    Aabb whole, vertex[3];

    MENISCUS_HD Own(const FeaturePairs& pairs, uint32_t place_)
        : place(place_),
          features(pairs.cloth.features[place_]),
          shown(pairs.shown(place_, features)),
          triangle(load(pairs.cloth.tree.triangles, place_)),
          whole(pairs.cloth.tree.box(0, place_)) {
      for (uint32_t k = 0; k < 3; ++k) vertex[k] = pairs.cloth.kept.box(corner_of(triangle, k));
    }
    MENISCUS_HD Aabb edge(uint32_t k) const { return joined(vertex[k], vertex[next(k)]); }
    MENISCUS_HD bool has_edge(uint32_t k) const { return (features & uint32_t{owns_edge} << k) != 0; }
    MENISCUS_HD bool shows_edge(uint32_t k) const { return (shown & uint32_t{owns_edge} << k) != 0; }
  };

  MENISCUS_HD static uint32_t next(uint32_t k) { return k < 2 ? k + 1 : 0; }

  template <class Visit>
  MENISCUS_HD static void vertices(const Own& own, const Own& other, const Visit& visit) {
    for (uint32_t k = 0; k < 3; ++k) {
      if (!(own.features & uint32_t{owns_vertex} << k) || !overlap(own.vertex[k], other.whole)) continue;
      if (!has_vertex(other.triangle, corner_of(own.triangle, k)))
        visit(FeatureCode{feature(own.place, k), feature(other.place, face)});
    }
  }

  template <class Visit>
  MENISCUS_HD static void edges(const Own& own, const Own& other, const Visit& visit) {
    for (uint32_t f = 0; f < 3; ++f) {
      if (!other.has_edge(f)) continue;
      const uint32_t s = corner_of(other.triangle, f), t = corner_of(other.triangle, next(f));
      const Aabb box = other.edge(f);
      for (uint32_t e = 0; e < 3; ++e) {
        if (!own.has_edge(e)) continue;
        const uint32_t v = corner_of(own.triangle, e), w = corner_of(own.triangle, next(e));
        if (s == v || s == w || t == v || t == w || !overlap(own.edge(e), box)) continue;
        const bool guards = !(own.shows_edge(e) && other.shows_edge(f));
        visit(FeatureCode{feature(own.place, 3 + e) | (guards ? FeatureCode::guard_bit : 0),
                          feature(other.place, 3 + f)});
      }
    }
  }
};

/// Pairs of groups while a group of threads looks through them: pairs of triangles whose boxes overlap, by
/// number; those of them that no plane parts; and pairs of features of some of these.
struct CandidateScratch {
  static constexpr uint32_t pairs = 16, at_once = 128, most_codes = 1024;

  uint16_t hits[64 * pairs], near[64 * pairs];
  FeatureCode codes[most_codes];
  uint32_t hit_count, near_count, code_count;
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
        group.for_each(1, [&](uint32_t) { scratch.code_count = 0; });
        group.for_each(now,
                       [&](uint32_t k) { find_features(scratch, places(first, scratch.near[done + k])); });
        const uint32_t found = scratch.code_count;
        group.for_each(found < Scratch::most_codes ? found : Scratch::most_codes,
                       [&](uint32_t k) { list(scratch.codes[k]); });
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
    features.of_two(two.first, two.second, [&](FeatureCode code) {
      const uint32_t place = pbd::atomic_add(scratch.code_count, 1);
      if (place < Scratch::most_codes)
        scratch.codes[place] = code;
      else
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
    float radius[2] = {0, 0};
    for (uint32_t k = 0; k < 4; ++k) {
      const Vec4 b = ball(corners.vertex(k));
      pair.start[k] = b.xyz() - origin;
      radius[k < first ? 0 : 1] = pbd::max(radius[k < first ? 0 : 1], b.w);
    }
    return nearest(pair, 0).distance <= radius[0] + radius[1];
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
