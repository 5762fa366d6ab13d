// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// From the tree to pairs of features that may touch: groups of triangles first, then their features' boxes.
#pragma once

#include "cloth/self_contacts_views.h"
#include "pbd/device/atomics.h"

namespace meniscus::cloth::self_contact_kernels {

/// Notes where each vertex is predicted to be, and how far it may end up from its way there.
struct Foresee {
  View<const Vec4> previous, position;  // by vertex
  View<const uint32_t> vertex_part;
  View<const Part> parts;
  View<const float> strayed;  // m, in the last substep
  View<Vec4> foreseen;
  View<uint32_t> limit, entries, counters;

  MENISCUS_HD void operator()(uint32_t v) const {
    const Vec3 x = position[v].xyz(), way = x - previous[v].xyz();
    const float thickness = parts[vertex_part[v]].thickness;
    foreseen[v] = pbd::with_w(x, 0.55f * thickness + 0.25f * length(way) + 1.5f * strayed[v]);
    limit[v] = no_index;
    entries[v] = 0;
    if (v != 0) return;
    for (uint32_t k = 0; k < counter_count; ++k) counters[k] = 0;
  }
};

/// The margin of Foresee, for the tree.
struct Reach {
  View<const Vec4> foreseen;

  MENISCUS_HD float operator()(uint32_t v, uint32_t /*part*/, Vec3 /*from*/, Vec3 /*to*/) const {
    return foreseen[v].w;
  }
};

/// A cone that holds the normals of a group's triangles, before and after its motion.
///
/// Where cloth is smooth, its vertices keep it apart from other cloth, and its edges need not be looked at:
/// with θ the angle that an edge of length L is bent by, it stands out by Lθ/4 between its ends.
struct FitCones {
  pbd::SurfaceTreeView tree;
  View<const Part> parts;
  View<const Vec4> previous, foreseen;
  View<Vec4> cones;
  View<uint32_t> rough, squeezed;

  MENISCUS_HD void operator()(uint32_t g) const {
    Vec3 axis{0, 0, 0};
    float longest = 0;
    for (uint32_t k = 0; k < 8; ++k)
      axis += normal(previous, 8 * g + k, longest) + normal(foreseen, 8 * g + k, longest);
    axis = normalized_or(axis, {0, 0, 0});
    float least = 1;
    for (uint32_t k = 0; k < 8; ++k) {
      if (tree.triangles[8 * g + k].a == no_index) continue;
      least = pbd::min(least, dot(axis, normal(previous, 8 * g + k, longest)));
      least = pbd::min(least, dot(axis, normal(foreseen, 8 * g + k, longest)));
    }
    const float angle = acosf(pbd::clamp(least, -1, 1));
    cones[g] = pbd::with_w(axis, angle);
    rough[g] = angle * sqrtf(longest) > 0.2f * parts[tree.triangles[8 * g].part].thickness;
    squeezed[g] = 0;
  }

  /// Of a triangle; and the square of the longest edge so far.
  MENISCUS_HD Vec3 normal(View<const Vec4> x, uint32_t place, float& longest) const {
    const SurfaceTriangle t = tree.triangles[place];
    if (t.a == no_index) return {0, 0, 0};
    const Vec3 ab = x[t.b].xyz() - x[t.a].xyz(), ac = x[t.c].xyz() - x[t.a].xyz(), bc = ac - ab;
    longest = pbd::max(longest, pbd::max(dot(ab, ab), pbd::max(dot(ac, ac), dot(bc, bc))));
    return normalized_or(cross(ab, ac), {0, 0, 0});
  }
};

/// Lists for each group those from itself on whose boxes overlap its own.
///
/// Neighbours in the material always do. They cannot touch while all their normals are within a half-space
/// (Volino & Magnenat-Thalmann 1994): such pairs are marked, and not looked at any further.
struct FindGroups {
  pbd::SurfaceTreeView tree;
  View<const Part> parts;
  View<const Vec4> cones;
  View<const uint32_t> neighbour_start, neighbours;
  View<uint32_t> rows, row_count, counters;
  uint32_t row_capacity;

  static constexpr float smooth = 1.3f;  // rad, the widest spread of normals in what counts as one sheet

  MENISCUS_HD void operator()(uint32_t g) const {
    const uint32_t part = tree.triangles[8 * g].part;
    uint32_t count = 0;
    pbd::for_each_overlap(tree, tree.box(1, g), 1, g, [&](uint32_t other) {
      if (!may_touch(part, tree.triangles[8 * other].part)) return;
      if (count < row_capacity)
        rows[g * row_capacity + count] = other | (is_one_sheet(g, other) ? in_one_sheet : 0);
      ++count;
    });
    row_count[g] = count;
    if (count > 0) pbd::atomic_max(counters[longest_row], count);
  }

  MENISCUS_HD bool may_touch(uint32_t p, uint32_t q) const {
    const Part a = parts[p], b = parts[q];
    if (p == q) return a.self != 0;
    return (a.filter_groups & b.filter_mask) != 0 && (b.filter_groups & a.filter_mask) != 0;
  }

  MENISCUS_HD bool is_one_sheet(uint32_t g, uint32_t other) const {
    const Vec4 a = cones[g], b = cones[other];
    if (g == other) return 2 * a.w < smooth;
    if (a.w + b.w >= smooth || dot(a.xyz(), b.xyz()) <= cosf(smooth - a.w - b.w)) return false;
    for (uint32_t n = neighbour_start[g]; n < neighbour_start[g + 1]; ++n)
      if (neighbours[n] == other) return true;
    return false;
  }
};

/// Pairs of features, of which each triangle shows those that it owns; of its edges, if not all are asked
/// for, those on a border or in a rough group.
struct FeaturePairs {
  ClothState cloth;
  bool all_edges;

  MENISCUS_HD uint32_t shown_features(uint32_t place) const {
    const uint32_t features = cloth.features[place];
    if (all_edges || cloth.rough[place / 8]) return features;
    return (features & ~(7u * owns_edge)) | features / is_border * owns_edge;
  }

  /// Calls visit(code) for each pair of the triangle at `place` and one in a later place of its group or in a
  /// group of its row for which wanted(entry of the row) holds.
  template <class Wanted, class Visit>
  MENISCUS_HD void of_place(uint32_t place, const Wanted& wanted, const Visit& visit) const {
    const uint32_t g = place / 8, row = cloth.row_size(g);
    if (row == 0 || cloth.tree.triangles[place].a == no_index) return;
    const Own own(*this, place);
    for (uint32_t n = 0; n < row; ++n) {
      const uint32_t entry = cloth.rows[g * cloth.row_capacity + n], other = entry & ~in_one_sheet;
      if (!wanted(entry) || !overlap(cloth.tree.box(1, other), own.whole)) continue;
      const pbd::BoxGroup& boxes = cloth.tree.group(0, other);
      uint32_t mask = overlap_mask(boxes, own.whole);
      if (other == g) mask &= ~((2u << place % 8) - 1);
      if (mask == 0) continue;
      own_vertices(own, other, boxes, mask, visit);
      for (; mask != 0; mask &= mask - 1) {
        const uint32_t other_place = 8 * other + pbd::lowest_bit(mask);
        const uint32_t features = shown_features(other_place);
        if (features & 7 * owns_vertex) other_vertices(own, other_place, features, visit);
        if (own.any_edges && features & 7 * owns_edge) edges(own, other_place, features, visit);
      }
    }
  }

 private:
  /// The triangle of which pairs are looked for, and the boxes of its vertices.
  struct Own {
    uint32_t place, features;
    SurfaceTriangle triangle;
    bool any_edges;
    Aabb whole, vertex[3];

    MENISCUS_HD Own(const FeaturePairs& pairs, uint32_t place_)
        : place(place_),
          features(pairs.shown_features(place_)),
          triangle(load(pairs.cloth.tree.triangles, place_)),
          any_edges((features & 7 * owns_edge) != 0),
          whole(pairs.cloth.tree.box(0, place_)) {
      for (uint32_t k = 0; k < 3; ++k)
        if (any_edges || features & uint32_t{owns_vertex} << k)
          vertex[k] = pairs.cloth.way_box(corner_of(triangle, k));
    }
    MENISCUS_HD Aabb edge(uint32_t k) const { return joined(vertex[k], vertex[next(k)]); }
  };

  MENISCUS_HD static uint32_t next(uint32_t k) { return k < 2 ? k + 1 : 0; }

  template <class Visit>
  MENISCUS_HD void own_vertices(const Own& own, uint32_t other, const pbd::BoxGroup& boxes, uint32_t among,
                                const Visit& visit) const {
    for (uint32_t k = 0; k < 3; ++k) {
      if (!(own.features & uint32_t{owns_vertex} << k)) continue;
      const uint32_t v = corner_of(own.triangle, k);
      for (uint32_t mask = among & overlap_mask(boxes, own.vertex[k]); mask != 0; mask &= mask - 1) {
        const uint32_t place = 8 * other + pbd::lowest_bit(mask);
        if (!has_vertex(load(cloth.tree.triangles, place), v))
          visit(FeatureCode{feature(own.place, k), feature(place, face)});
      }
    }
  }

  template <class Visit>
  MENISCUS_HD void other_vertices(const Own& own, uint32_t place, uint32_t features,
                                  const Visit& visit) const {
    const SurfaceTriangle other = load(cloth.tree.triangles, place);
    for (uint32_t k = 0; k < 3; ++k) {
      if (!(features & uint32_t{owns_vertex} << k)) continue;
      const uint32_t v = corner_of(other, k);
      if (!has_vertex(own.triangle, v) && overlap(cloth.way_box(v), own.whole))
        visit(FeatureCode{feature(place, k), feature(own.place, face)});
    }
  }

  template <class Visit>
  MENISCUS_HD void edges(const Own& own, uint32_t place, uint32_t features, const Visit& visit) const {
    const SurfaceTriangle other = load(cloth.tree.triangles, place);
    for (uint32_t f = 0; f < 3; ++f) {
      if (!(features & uint32_t{owns_edge} << f)) continue;
      const uint32_t s = corner_of(other, f), t = corner_of(other, next(f));
      const Aabb box = joined(cloth.way_box(s), cloth.way_box(t));
      for (uint32_t e = 0; e < 3; ++e) {
        if (!(own.features & uint32_t{owns_edge} << e)) continue;
        const uint32_t v = corner_of(own.triangle, e), w = corner_of(own.triangle, next(e));
        if (s == v || s == w || t == v || t == w || !overlap(own.edge(e), box)) continue;
        visit(FeatureCode{feature(own.place, 3 + e), feature(place, 3 + f)});
      }
    }
  }
};

/// Lists the pairs of each triangle. A few are kept back, so that the list's end is asked for seldom.
struct FindCandidates {
  FeaturePairs pairs;
  View<FeatureCode> candidate_list;
  View<uint32_t> counters;

  MENISCUS_HD void operator()(uint32_t place) const {
    constexpr uint32_t room = 8;
    FeatureCode found[room];
    uint32_t count = 0;
    pairs.of_place(
        place, [](uint32_t entry) { return !(entry & in_one_sheet); },
        [&](FeatureCode code) {
          if (count == room) {
            put(found, count);
            count = 0;
          }
          found[count++] = code;
        });
    if (count > 0) put(found, count);
  }

  MENISCUS_HD void put(const FeatureCode* found, uint32_t count) const {
    const uint32_t first = pbd::append(counters[candidates], count);
    for (uint32_t k = 0; k < count; ++k)
      if (first + k < candidate_list.count) candidate_list[first + k] = found[k];
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
