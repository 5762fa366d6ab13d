// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Pairs of features of two triangles.
#pragma once

#include "cloth/self_contact/views.h"

namespace meniscus::cloth::self_contact_kernels {

/// A triangle with the features that it owns, and which of its edges may have contacts.
struct OwnFeatures {
  static constexpr uint16_t is_rough = 1 << 9;  ///< beside the bits of its features: its group is rough

  SurfaceTriangle triangle;
  uint32_t features, shown;

  MENISCUS_HD OwnFeatures(const SurfaceTriangle& t, uint32_t bits)
      : triangle(t), features(bits), shown(bits & is_rough ? bits : bits / is_border * owns_edge) {}

  MENISCUS_HD bool has_vertex(uint32_t k) const { return (features & uint32_t{owns_vertex} << k) != 0; }
  MENISCUS_HD bool has_edge(uint32_t k) const { return (features & uint32_t{owns_edge} << k) != 0; }
  MENISCUS_HD bool shows_edge(uint32_t k) const { return (shown & uint32_t{owns_edge} << k) != 0; }
  MENISCUS_HD bool shares_end(uint32_t e, const OwnFeatures& other, uint32_t f) const {
    const uint32_t v = corner_of(triangle, e), w = corner_of(triangle, next_corner(e)),
                   s = corner_of(other.triangle, f), t = corner_of(other.triangle, next_corner(f));
    return s == v || s == w || t == v || t == w;
  }
};

MENISCUS_HD inline uint16_t bits_of_features(const ClothState& cloth, uint32_t place) {
  return cloth.features[place] | (cloth.rough[place / 8] ? OwnFeatures::is_rough : uint16_t{0});
}
MENISCUS_HD inline OwnFeatures own_features(const ClothState& cloth, uint32_t place) {
  return {load(cloth.tree.triangles, place), bits_of_features(cloth, place)};
}

/// Pairs of features of two triangles, by number: six of a vertex and a face, then nine of two edges.
struct PairsOfTwo {
  static constexpr uint32_t most = 15;

  uint32_t mask = 0;          ///< the pairs that exist
  uint32_t for_failsafe = 0;  ///< those that only the fail-safe checks, and that never become contacts

  /// All pairs that share no vertex. Pairs with an edge that is neither on a border nor in a rough group are
  /// only for the fail-safe.
  MENISCUS_HD PairsOfTwo(const OwnFeatures& a, const OwnFeatures& b) {
    MENISCUS_UNROLL
    for (uint32_t k = 0; k < 3; ++k) {
      if (a.has_vertex(k) && !has_vertex(b.triangle, corner_of(a.triangle, k))) mask |= 1u << k;
      if (b.has_vertex(k) && !has_vertex(a.triangle, corner_of(b.triangle, k))) mask |= 8u << k;
    }
    MENISCUS_UNROLL
    for (uint32_t k = 0; k < 9; ++k) {
      const uint32_t e = k / 3, f = k % 3;
      if (!a.has_edge(e) || !b.has_edge(f) || a.shares_end(e, b, f)) continue;
      mask |= 64u << k;
      if (!(a.shows_edge(e) && b.shows_edge(f))) for_failsafe |= 64u << k;
    }
  }

  /// The code of the k-th pair of the triangles at two places.
  MENISCUS_HD FeatureCode code(GroupPair places, uint32_t k) const {
    if (k < 3) return {feature(places.first, k), feature(places.second, face)};
    if (k < 6) return {feature(places.second, k - 3), feature(places.first, face)};
    const uint32_t e = (k - 6) / 3, f = (k - 6) % 3;
    return {feature(places.first, 3 + e) | (for_failsafe >> k & 1 ? FeatureCode::failsafe_bit : 0),
            feature(places.second, 3 + f)};
  }
};

/// The tree's boxes during a substep. Where all cloth is in one frame, they are compared at its end alone.
struct BoxesInTime {
  const pbd::SurfaceTreeView& tree;
  bool differ;  // frames

  /// Whether boxes a and b of two levels overlap.
  MENISCUS_HD bool overlap(uint32_t level, uint32_t a, uint32_t other_level, uint32_t b) const {
    return (mask(level, a / 8, other_level, b) >> a % 8 & 1) != 0;
  }
  /// A bit mask of the boxes of a group of a level that overlap box b of another.
  MENISCUS_HD uint32_t mask(uint32_t level, uint32_t group, uint32_t other_level, uint32_t b) const {
    if (!differ) return overlap_mask(tree.group(level, group), tree.box(other_level, b));
    return overlap_mask(tree.group_before(level, group), tree.group(level, group),
                        tree.moving_box(other_level, b));
  }
};

/// A bit mask of the triangles of group `other` whose boxes overlap that of the triangle at `place`. In its
/// own group, only later triangles count. `differ`: see BoxesInTime.
MENISCUS_HD inline uint32_t overlapping(const pbd::SurfaceTreeView& tree, uint32_t place, uint32_t other,
                                        bool differ = false) {
  const uint32_t mask = BoxesInTime{tree, differ}.mask(0, other, 0, place);
  return other == place / 8 ? mask & ~((2u << place % 8) - 1) : mask;
}

}  // namespace meniscus::cloth::self_contact_kernels
