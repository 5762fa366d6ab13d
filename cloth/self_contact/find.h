// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The search for candidates: from pairs of groups to pairs of features that may touch.
#pragma once

#include "cloth/self_contact/candidate_lifetime.h"
#include "cloth/self_contact/features.h"

namespace meniscus::cloth::self_contact_kernels {

/// The four corners of a pair of features, each with its motion bound. They are a vertex and the three
/// corners of a triangle, or the ends of two edges.
struct CornerBounds {
  Vec4 corner[4];
  bool edges;

  /// Whether the boxes of both features overlap.
  MENISCUS_HD bool have_boxes_in_touch() const {
    const Aabb last = joined(box(2), box(3));
    return edges ? overlap(joined(box(0), box(1)), last) : overlap(box(0), joined(box(1), last));
  }
  /// Whether the features may come near. No point of a feature leaves the feature of the spheres' centres by
  /// more than the greatest radius of its spheres.
  MENISCUS_HD bool may_come_near() const {
    const Vec3 origin = corner[0].xyz();
    const uint32_t first = edges ? 2 : 1;
    FeaturePair pair{};
    pair.edges = edges;
    float radius = 0, other_radius = 0;
    MENISCUS_UNROLL
    for (uint32_t k = 0; k < 4; ++k) {
      pair.start[k] = corner[k].xyz() - origin;
      (k < first ? radius : other_radius) = pbd::max(k < first ? radius : other_radius, corner[k].w);
    }
    return nearest(pair, 0).distance <= radius + other_radius;
  }

 private:
  MENISCUS_HD Aabb box(uint32_t k) const {
    return pbd::inflated({corner[k].xyz(), corner[k].xyz()}, corner[k].w);
  }
};

/// The triangles of two groups: first those of one group, then those of the other. All threads read them.
///
/// Bounds of different frames are compared in that of the first group. There, the others sweep over the path
/// of their frame, and this path widens them.
struct TrianglesOfTwo {
  static constexpr uint32_t count = 16;

  GroupPair groups;
  uint16_t features[count];  // see OwnFeatures
  uint32_t vertex[3 * count];
  Vec4 bound[3 * count];  // by corner: its motion bound

  MENISCUS_HD void load_triangle(const ClothState& cloth, uint32_t k) {
    const uint32_t place = 8 * (k < 8 ? groups.first : groups.second) + k % 8;
    const SurfaceTriangle t = load(cloth.tree.triangles, place);
    if (t.a == no_index) return;
    features[k] = bits_of_features(cloth, place);
    const Vec3 way = k < 8 ? Vec3{0, 0, 0} : way_of_second(cloth);
    const float half = 0.5f * length(way);
    for (uint32_t corner = 0; corner < 3; ++corner) {
      vertex[3 * k + corner] = corner_of(t, corner);
      const Vec4 sphere = load(cloth.kept.spheres, corner_of(t, corner));
      bound[3 * k + corner] = pbd::with_w(sphere.xyz() - 0.5f * way, sphere.w + half);
    }
  }
  /// m, the displacement of the second group's frame in that of the first.
  MENISCUS_HD Vec3 way_of_second(const ClothState& cloth) const {
    const auto frame = [&](uint32_t group) {
      return cloth.frames.at_piece(cloth.tree.triangles[8 * group].piece).xyz();
    };
    return frame(groups.second) - frame(groups.first);
  }

  MENISCUS_HD OwnFeatures self(uint32_t k) const {
    return {{vertex[3 * k], vertex[3 * k + 1], vertex[3 * k + 2], 0}, features[k]};
  }
  /// The corners of the k-th pair of features of triangles s and t.
  MENISCUS_HD CornerBounds bounds(uint32_t s, uint32_t t, uint32_t k) const {
    const Vec4 *a = bound + 3 * s, *b = bound + 3 * t;
    if (k < 3) return {{a[k], b[0], b[1], b[2]}, false};
    if (k < 6) return {{b[k - 3], a[0], a[1], a[2]}, false};
    const uint32_t e = (k - 6) / 3, f = (k - 6) % 3;
    return {{a[e], a[next_corner(e)], b[f], b[next_corner(f)]}, true};
  }
  /// Whether a plane separates the triangles: one perpendicular to the line between their centres, or one
  /// parallel to either triangle.
  MENISCUS_HD bool are_parted(uint32_t s, uint32_t t) const {
    for (uint32_t k = 0; k < 9; ++k)
      if (vertex[3 * s + k / 3] == vertex[3 * t + k % 3]) return false;
    const Vec3 origin = bound[3 * s].xyz();
    const Middle a(bound + 3 * s, origin), b(bound + 3 * t, origin);
    const float reach = a.radius + b.radius;
    const auto parts = [&](Vec3 n) {
      return pbd::max(a.least(n) - b.most(n), b.least(n) - a.most(n)) > reach * length(n);
    };
    return parts(a.centre() - b.centre()) || parts(a.normal()) || parts(b.normal());
  }

 private:
  /// A triangle between the centres of its vertices' spheres, relative to an origin.
  struct Middle {
    Vec3 corner[3];
    float radius = 0;

    MENISCUS_HD Middle(const Vec4* bound, Vec3 origin) {
      MENISCUS_UNROLL
      for (uint32_t k = 0; k < 3; ++k) {
        corner[k] = bound[k].xyz() - origin;
        radius = pbd::max(radius, bound[k].w);
      }
    }
    MENISCUS_HD Vec3 normal() const { return cross(corner[1] - corner[0], corner[2] - corner[0]); }
    MENISCUS_HD Vec3 centre() const { return (1.0f / 3) * (corner[0] + corner[1] + corner[2]); }
    MENISCUS_HD float least(Vec3 n) const {
      return pbd::min(dot(n, corner[0]), pbd::min(dot(n, corner[1]), dot(n, corner[2])));
    }
    MENISCUS_HD float most(Vec3 n) const {
      return pbd::max(dot(n, corner[0]), pbd::max(dot(n, corner[1]), dot(n, corner[2])));
    }
  };
};

/// Working memory of a group of threads for pairs of groups. It holds the numbers of the pairs of triangles
/// whose boxes overlap. For some of these it also holds the numbers of the pairs of features whose boxes
/// overlap.
struct CandidateScratch {
  static constexpr uint32_t pairs = 16, at_once = 128;

  TrianglesOfTwo two[pairs];
  uint16_t hits[64 * pairs], touching[PairsOfTwo::most * at_once];
  uint32_t hit_count, touching_count;
};

/// Lists the pairs of features that may meet while all vertices stay inside their motion bounds. It takes
/// several pairs of groups at a time. Each test leaves few of the pairs that the one before has found, and
/// all threads share what is left.
struct FindCandidates {
  using Scratch = CandidateScratch;

  Listing listing;
  ClothState cloth;
  GroupPairs all_pairs;
  View<FeatureCode> candidate_list;
  uint32_t worlds;
  uint32_t stride;  // groups of threads for each world

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    const uint32_t world = n / stride;
    if (!listing.wanted(world)) return;
    const GroupPairs pairs = all_pairs.of(world, all_pairs.list.count / worlds);
    const View<FeatureCode> found = part_of(candidate_list, world, candidate_list.count / worlds);
    const uint32_t count = pairs.count();
    for (uint32_t first = Scratch::pairs * (n % stride); first < count; first += Scratch::pairs * stride) {
      const uint32_t left = count - first < Scratch::pairs ? count - first : Scratch::pairs;
      group.for_each(left, [&](uint32_t k) {
        scratch.two[k].groups = pairs.list[first + k];
        if (k == 0) scratch.hit_count = 0;
      });
      group.for_each(TrianglesOfTwo::count * left, [&](uint32_t k) {
        scratch.two[k / TrianglesOfTwo::count].load_triangle(cloth, k % TrianglesOfTwo::count);
      });
      const bool differ = pairs.counters[several_frames] != 0;
      group.for_each(8 * left, [&](uint32_t k) { find_overlaps(scratch, k, differ); });
      const uint32_t hits = scratch.hit_count;
      for (uint32_t done = 0; done < hits; done += Scratch::at_once) {
        const uint32_t now = hits - done < Scratch::at_once ? hits - done : Scratch::at_once;
        group.for_each(1, [&](uint32_t) { scratch.touching_count = 0; });
        group.for_each(now, [&](uint32_t k) { find_features(scratch, scratch.hits[done + k]); });
        group.for_each(scratch.touching_count,
                       [&](uint32_t k) { list(scratch, scratch.touching[k], pairs, found); });
      }
    }
  }

 private:
  MENISCUS_HD void find_overlaps(Scratch& scratch, uint32_t k, bool differ) const {
    const GroupPair pair = scratch.two[k / 8].groups;
    uint32_t mask = overlapping(cloth.tree, 8 * pair.first + k % 8, pair.second, differ);
    uint32_t place = mask ? pbd::append(scratch.hit_count, pbd::bit_count(mask)) : 0;
    for (; mask != 0; mask &= mask - 1)
      scratch.hits[place++] = static_cast<uint16_t>(8 * k + pbd::lowest_bit(mask));
  }
  MENISCUS_HD void find_features(Scratch& scratch, uint32_t hit) const {
    const TrianglesOfTwo& two = scratch.two[hit / 64];
    const uint32_t s = hit % 64 / 8, t = 8 + hit % 8;
    if (two.are_parted(s, t)) return;
    uint32_t mask = PairsOfTwo(two.self(s), two.self(t)).mask, touching = 0;
    for (; mask != 0; mask &= mask - 1) {
      const uint32_t k = pbd::lowest_bit(mask);
      if (two.bounds(s, t, k).have_boxes_in_touch()) touching |= 1u << k;
    }
    if (touching == 0) return;
    uint32_t place = pbd::append(scratch.touching_count, pbd::bit_count(touching));
    for (; touching != 0; touching &= touching - 1)
      scratch.touching[place++] = static_cast<uint16_t>(PairsOfTwo::most * hit + pbd::lowest_bit(touching));
  }
  MENISCUS_HD void list(const Scratch& scratch, uint32_t number, const GroupPairs& pairs,
                        View<FeatureCode> found) const {
    const uint32_t hit = number / PairsOfTwo::most, k = number % PairsOfTwo::most;
    const TrianglesOfTwo& two = scratch.two[hit / 64];
    const uint32_t s = hit % 64 / 8, t = 8 + hit % 8;
    if (!two.bounds(s, t, k).may_come_near()) return;
    const uint32_t place = pbd::append(pairs.counters[candidates], 1);
    if (place < found.count)
      found[place] = PairsOfTwo(two.self(s), two.self(t)).code(places_of(two.groups, hit % 64), k);
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
