// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// From the tree to pairs of features that may touch: groups of triangles first, then their features' boxes.
#pragma once

#include "cloth/self_contacts_zones.h"

namespace meniscus::cloth::self_contact_kernels {

/// Notes where each vertex is predicted to be, and whether the lists of pairs still hold for it: it must stay
/// where it was to stay, with room for what the solve may move it by, and for the thickness.
struct Foresee {
  View<const Vec4> previous, position;  // by vertex
  View<const uint32_t> vertex_part;
  View<const Part> parts;
  View<const float> strayed;  // m, in the last substep
  KeptPlaces kept;
  View<Vec4> foreseen;  // w: the room, m
  Zones zones;
  View<uint32_t> entries, counters;
  bool anew;  // whatever there is

  MENISCUS_HD void operator()(uint32_t v) const {
    const Vec3 x = position[v].xyz(), way = x - previous[v].xyz();
    const float thickness = parts[vertex_part[v]].thickness;
    const float room = 0.55f * thickness + 0.25f * length(way) + 1.5f * strayed[v];
    foreseen[v] = pbd::with_w(x, room);
    if (anew || length(x - kept.balls[v].xyz()) + room > kept.balls[v].w)
      pbd::atomic_max(counters[expired], 1);
    zones.begin(v);
    entries[v] = 0;
    if (v != 0) return;
    counters[contacts] = 0;
    if (anew) counters[listings] = 0;
    for (uint32_t round = 0; round < most_rounds; ++round) counters[crossings + round] = 0;
  }
};

/// Where the lists have expired: what is to be listed anew.
struct Listing {
  View<const uint32_t> counters;

  MENISCUS_HD bool wanted() const { return counters[expired] != 0; }
};

/// Chooses where vertices are to stay until pairs are looked for again: around the way that each will make if
/// it goes on as it does.
struct Keep {
  Listing listing;
  View<const Vec4> previous, foreseen;
  View<const uint32_t> vertex_part;
  View<const Part> parts;
  View<Vec4> kept;
  View<uint32_t> counters;

  // The balls of what lies side by side must not meet, or all of a rough sheet is listed.
  static constexpr float longest = 16;     // substeps
  static constexpr float furthest = 0.5f;  // of the thickness, if that takes more than this substep
  static constexpr float leeway = 0.25f;   // of the thickness, to go otherwise

  MENISCUS_HD void operator()(uint32_t v) const {
    if (!listing.wanted()) return;
    const Vec3 from = previous[v].xyz(), way = foreseen[v].xyz() - from;
    const float thickness = parts[vertex_part[v]].thickness, far = length(way);
    const float substeps = pbd::clamp(furthest * thickness / pbd::max(far, 1e-30f), 1, longest);
    kept[v] =
        pbd::with_w(from + 0.5f * substeps * way, 0.5f * substeps * far + foreseen[v].w + leeway * thickness);
    if (v != 0) return;
    counters[group_pairs] = counters[candidates] = 0;
    ++counters[listings];
  }
};

/// Boxes around where vertices are to stay, for the tree.
struct KeptBoxes {
  Listing listing;
  KeptPlaces kept;

  MENISCUS_HD bool wanted() const { return listing.wanted(); }
  MENISCUS_HD Aabb of(uint32_t v) const { return kept.box(v); }
};

/// Sixteen groups of eight triangles while their cones are fitted.
struct ConeScratch {
  static constexpr uint32_t groups = 16, triangles = 8 * groups;

  Vec3 before[triangles], after[triangles];  // normals
  float longest2[triangles];                 // m²: of the edges
  Vec3 axis[groups];
};

/// A cone that holds the normals of a group's triangles, before and after its motion.
///
/// Where cloth is smooth, its vertices keep it apart from other cloth, and its edges need not be looked at:
/// with θ the angle that an edge of length L is bent by, it stands out by Lθ/4 between its ends.
struct FitCones {
  using Scratch = ConeScratch;

  Listing listing;
  pbd::SurfaceTreeView tree;
  View<const Part> parts;
  View<const Vec4> previous, position;
  View<Vec4> cones;
  View<uint32_t> rough;

  /// Of the groups from 16 n on.
  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    if (!listing.wanted()) return;
    const uint32_t first = n * Scratch::groups, left = cones.count - first,
                   count = left < Scratch::groups ? left : Scratch::groups;
    group.for_each(8 * count, [&](uint32_t k) {
      const SurfaceTriangle t = load(tree.triangles, 8 * first + k);
      scratch.longest2[k] = 0;
      scratch.before[k] = normal(previous, t, scratch.longest2[k]);
      scratch.after[k] = normal(position, t, scratch.longest2[k]);
    });
    group.for_each(count, [&](uint32_t g) {
      Vec3 sum{0, 0, 0};
      for (uint32_t k = 8 * g; k < 8 * g + 8; ++k) sum += scratch.before[k] + scratch.after[k];
      scratch.axis[g] = normalized_or(sum, {0, 0, 0});
    });
    group.for_each(count, [&](uint32_t g) { fit(scratch, first, g); });
  }

 private:
  MENISCUS_HD void fit(const Scratch& scratch, uint32_t first, uint32_t g) const {
    const Vec3 axis = scratch.axis[g];
    float least = 1, longest2 = 0;
    for (uint32_t k = 8 * g; k < 8 * g + 8; ++k) {
      if (tree.triangles[8 * first + k].a == no_index) continue;
      least = pbd::min(least, pbd::min(dot(axis, scratch.before[k]), dot(axis, scratch.after[k])));
      longest2 = pbd::max(longest2, scratch.longest2[k]);
    }
    const float angle = acosf(pbd::clamp(least, -1, 1));
    cones[first + g] = pbd::with_w(axis, angle);
    rough[first + g] = angle * sqrtf(longest2) > 0.2f * parts[tree.triangles[8 * (first + g)].part].thickness;
  }

  /// Of a triangle; and the square of the longest edge so far.
  MENISCUS_HD static Vec3 normal(View<const Vec4> x, const SurfaceTriangle& t, float& longest2) {
    if (t.a == no_index) return {0, 0, 0};
    const Vec3 a = x[t.a].xyz(), ab = x[t.b].xyz() - a, ac = x[t.c].xyz() - a, bc = ac - ab;
    longest2 = pbd::max(longest2, pbd::max(dot(ab, ab), pbd::max(dot(ac, ac), dot(bc, bc))));
    return normalized_or(cross(ab, ac), {0, 0, 0});
  }
};

/// While eight groups look for those that they overlap: boxes of 512 other groups, and eights, by number.
struct OverlapScratch {
  static constexpr uint32_t boxes = 128;

  uint32_t tops[boxes], eights[8 * boxes];
  uint32_t top_count, count;
};

/// Lists the pairs of groups whose boxes overlap, for eight groups at a time: of a number of the tree's boxes
/// after the other, those eights below that overlap all of the own ones, then their groups; in large trees
/// the boxes above them come first. Neighbours in the material always do; in smooth sheets they are left out.
struct FindGroups {
  using Scratch = OverlapScratch;

  Listing listing;
  pbd::SurfaceTreeView tree;
  View<const Part> parts;
  SheetViews sheets;
  GroupPairs pairs;

  /// For the groups from 8 n on, and those behind them.
  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    if (!listing.wanted()) return;
    group.for_each(8, [&](uint32_t k) { note_smoothness(8 * n + k); });
    const bool large = tree.levels > 4;
    const uint32_t end = large ? tree.boxes[4] : eights_have_boxes() ? tree.groups_of(2) : 1;
    for (uint32_t first = large ? n / 64 : n / 8; first < end; first += Scratch::boxes) {
      const uint32_t boxes = end - first < Scratch::boxes ? end - first : Scratch::boxes;
      if (large)
        look_below(group, scratch, n, first, boxes);
      else
        pair_up_all(group, scratch, n, boxes, [&](uint32_t k) { return first + k; });
    }
  }

 private:
  /// Boxes of level 4 from `first` on.
  template <class Group>
  MENISCUS_HD void look_below(const Group& group, Scratch& scratch, uint32_t n, uint32_t first,
                              uint32_t boxes) const {
    group.for_each(1, [&](uint32_t) { scratch.top_count = 0; });
    group.for_each(boxes, [&](uint32_t k) {
      if (overlap(tree.box(4, first + k), tree.box(2, n)))
        scratch.tops[pbd::append(scratch.top_count, 1)] = first + k;
    });
    const uint32_t below = 8 * scratch.top_count;
    for (uint32_t done = 0; done < below; done += Scratch::boxes) {
      const uint32_t left = below - done < Scratch::boxes ? below - done : Scratch::boxes;
      pair_up_all(group, scratch, n, left,
                  [&](uint32_t k) { return 8 * scratch.tops[(done + k) / 8] + k % 8; });
    }
  }
  /// `count` boxes of the level above the eights'.
  template <class Group, class BoxAt>
  MENISCUS_HD void pair_up_all(const Group& group, Scratch& scratch, uint32_t n, uint32_t count,
                               const BoxAt& box_at) const {
    group.for_each(1, [&](uint32_t) { scratch.count = 0; });
    group.for_each(count, [&](uint32_t k) { look_into(scratch, n, box_at(k)); });
    const uint32_t found = scratch.count;
    group.for_each(8 * found, [&](uint32_t k) { pair_up(8 * n + k % 8, scratch.eights[k / 8]); });
  }
  MENISCUS_HD bool eights_have_boxes() const { return tree.levels > 2; }

  MENISCUS_HD void note_smoothness(uint32_t g) const {
    if (g >= sheets.smooth.count) return;
    sheets.smooth[g] = sheets.is_smooth(g);
  }

  MENISCUS_HD void look_into(Scratch& scratch, uint32_t n, uint32_t box) const {
    const Aabb own = eights_have_boxes() ? tree.box(2, n) : pbd::empty_box;
    if (tree.levels > 3 && !overlap(tree.box(3, box), own)) return;
    uint32_t mask =
        eights_have_boxes() ? overlap_mask(tree.group(2, box), own) : (1u << tree.groups_of(1)) - 1;
    for (; mask != 0; mask &= mask - 1) {
      const uint32_t eight = 8 * box + pbd::lowest_bit(mask);
      if (eight >= n) scratch.eights[pbd::append(scratch.count, 1)] = eight;
    }
  }

  MENISCUS_HD void pair_up(uint32_t g, uint32_t eight) const {
    uint32_t mask = overlap_mask(tree.group(1, eight), tree.box(1, g));
    if (eight == g / 8) mask &= ~0u << g % 8;
    if (mask == 0) return;
    const uint32_t part = tree.triangles[8 * g].part;
    Appending<GroupPair> found(pairs.list, pairs.counters[group_pairs]);
    for (; mask != 0; mask &= mask - 1) {
      const uint32_t other = 8 * eight + pbd::lowest_bit(mask);
      if (may_touch(part, tree.triangles[8 * other].part) && !sheets.has_in_sheet(g, other))
        found.add({g, other});
    }
    found.flush();
  }

  MENISCUS_HD bool may_touch(uint32_t p, uint32_t q) const {
    const Part a = parts[p], b = parts[q];
    if (p == q) return a.self != 0;
    return (a.filter_groups & b.filter_mask) != 0 && (b.filter_groups & a.filter_mask) != 0;
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
