// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the kernels of cloth-to-cloth contacts share.
#pragma once

#include "cloth/self_contact/tables.h"
#include "cloth/self_contact/tuning.h"
#include "pbd/device/base/atomics.h"
#include "pbd/feature_pair.h"
#include "pbd/particles.h"
#include "pbd/surface_tree/boxes.h"

namespace meniscus::cloth::self_contact_kernels {

using pbd::corner_weights;
using pbd::FeaturePair;
using pbd::joined;
using pbd::Nearest;
using pbd::nearest;
using pbd::no_index;
using pbd::overlap;
using pbd::relative_motion;
using pbd::SurfaceTriangle;
using pbd::time_of_nearness;
using pbd::Vec4;
using pbd::View;

struct PieceProperties {
  float thickness;  // m
  float friction;
  uint32_t filter_groups, filter_mask;
  uint32_t self;
  float nearness;  // m: half of the distance at which any pair is a contact
};

/// The rounds of the fail-safe are counted one by one.
inline constexpr uint32_t most_rounds = 32;
enum Counter : uint32_t {
  candidates,
  contacts,
  group_pairs,
  expired,               // not 0: the lists of pairs no longer hold
  long_expired,          // not 0: lists made for many substeps would not hold either
  age,                   // of the lists, substeps
  listings,              // searches since the step's start
  one_substep_listings,  // those made for one substep only
  overflowed,            // not 0: a list had no room, and the step will be repeated
  lost,                  // not 0: a vertex was rolled back, and its momentum is still to be transferred
  folded_sheets,         // groups whose sheets have folded, in this round of the fail-safe
  given_up,              // for the host alone: substeps whose last possible round still found a pair
  several_frames,        // not 0: the lists are for pieces in different frames, and so for one substep only
  frames_meet,           // not 0: pieces in different frames have touched, and the step will be repeated
  cells_meet,            // not 0: pieces that move differently are near
  crossings,
  counter_count = crossings + most_rounds
};

/// How many of each a world of a batch has (pbd/worlds.h). Those of its worlds follow one another, and are
/// numbered so. Lists and counters are those of each world: it searches, solves and repeats rounds by itself.
struct OfWorld {
  uint32_t vertices = 0, groups = 0, pieces = 0, frames = 0;
};

/// The part of an array that belongs to a world, where all have as much.
template <class T>
MENISCUS_HD View<T> part_of(View<T> all, uint32_t world, uint32_t each) {
  return {all.data + size_t{world} * each, each};
}
template <class T>
MENISCUS_HD View<T> counters_of(View<T> all, uint32_t world) {
  return part_of(all, world, counter_count);
}

/// Which groups of triangles a group of threads takes: of a world, so many from the first on.
struct GroupRange {
  uint32_t world, first, count;

  /// The n-th group of threads, of which each takes up to `most`.
  MENISCUS_HD GroupRange(uint32_t n, uint32_t most, uint32_t groups_of_world) {
    const uint32_t blocks = (groups_of_world + most - 1) / most, begin = n % blocks * most;
    world = n / blocks;
    first = world * groups_of_world + begin;
    count = groups_of_world - begin < most ? groups_of_world - begin : most;
  }
};

/// Whether a round of the fail-safe has anything to do: the first has, and later ones if the round before
/// found a pair.
MENISCUS_HD inline bool is_round_needed(View<const uint32_t> found, uint32_t round) {
  return found[overflowed] == 0 && (round == 0 || found[crossings + round - 1] != 0);
}

/// A feature of the triangle at a place: 0 to 2 for a vertex, 3 to 5 for an edge, 6 for the face.
using Feature = uint32_t;
inline constexpr uint32_t face = 6;

MENISCUS_HD constexpr Feature feature(uint32_t place, uint32_t which) {
  return place << 3 | which;
}

/// A vertex and a face, or two edges. Bit 31 of the first: only the fail-safe checks the pair, and it becomes
/// no contact.
struct FeatureCode {
  static constexpr uint32_t failsafe_bit = 1u << 31;

  Feature first, second;

  MENISCUS_HD bool is_for_failsafe() const { return (first & failsafe_bit) != 0; }
  MENISCUS_HD uint32_t first_place() const { return (first & ~failsafe_bit) >> 3; }
  MENISCUS_HD uint32_t second_place() const { return second >> 3; }
};

/// Two groups of triangles whose boxes overlap, first ≤ second; or one group, with itself.
struct GroupPair {
  uint32_t first, second;
};

/// The places of two of their triangles, k < 64.
MENISCUS_HD inline GroupPair places_of(GroupPair pair, uint32_t k) {
  return {8 * pair.first + k / 8, 8 * pair.second + k % 8};
}

/// Appends elements to a list, several at once, since all threads contend for the end of the list.
template <class T>
class Appending {
 public:
  MENISCUS_HD Appending(View<T> list, uint32_t& size) : list_(list), size_(size) {}

  MENISCUS_HD void add(const T& element) {
    if (count_ == room) flush();
    kept_[count_++] = element;
  }
  MENISCUS_HD void flush() {
    if (count_ == 0) return;
    const uint32_t first = pbd::append(size_, count_);
    for (uint32_t k = 0; k < count_; ++k) {
      const uint32_t place = first + k;
      if (place < list_.count) list_[place] = kept_[k];
    }
    count_ = 0;
  }

 private:
  static constexpr uint32_t room = 8;

  View<T> list_;
  uint32_t& size_;
  uint32_t count_ = 0;
  T kept_[room];
};

/// The motion bounds of vertices while lists of pairs are kept: spheres that move with the frames. Positions
/// inside them at the start and at the end of a substep are inside all the time, as both move steadily.
struct MotionBounds {
  View<const Vec4> spheres;  // by vertex: centre at the end of this substep, and radius, m

  MENISCUS_HD Aabb box(uint32_t v) const {
    const Vec4 sphere = load(spheres, v);
    return pbd::inflated({sphere.xyz(), sphere.xyz()}, sphere.w);
  }
  /// The position inside the motion bound of v that is nearest to x.
  MENISCUS_HD Vec3 inside(uint32_t v, Vec3 x) const {
    const Vec4 sphere = spheres[v];
    const Vec3 out = x - sphere.xyz();
    const float far2 = dot(out, out), most = self_contact_tuning::within * sphere.w;
    return far2 <= most * most ? x : sphere.xyz() + (most / sqrtf(far2)) * out;
  }
};

/// The number of elements in a list, which may be less than the number found.
template <class T>
MENISCUS_HD uint32_t listed(View<T> list, uint32_t found) {
  return found < list.count ? found : list.count;
}

/// Pairs of groups whose boxes overlap, except pairs in smooth sheets.
struct GroupPairs {
  View<GroupPair> list;
  View<uint32_t> counters;

  MENISCUS_HD uint32_t count() const { return listed(list, counters[group_pairs]); }
  /// Those of one world, of all.
  MENISCUS_HD GroupPairs of(uint32_t world, uint32_t each) const {
    return {part_of(list, world, each), counters_of(counters, world)};
  }
};

/// Which groups have smooth surroundings. The normals of a group and of all its neighbours, which share a
/// vertex with it, may lie within one half-space. Then no two of these triangles can touch (Volino &
/// Magnenat-Thalmann 1994), and pairs of the group and its neighbours are left out. The normals of the two
/// groups of a pair alone do not suffice, as the sheet between them may be folded.
struct SheetViews {
  View<const Vec4> cones;                            // by group: an axis, and the widest angle to it, rad
  View<const uint32_t> neighbour_start, neighbours;  // by group, including itself
  View<uint32_t> smooth;                             // by group

  MENISCUS_HD bool is_smooth(uint32_t g) const {
    const Vec3 axis = cones[g].xyz();
    for (uint32_t n = neighbour_start[g]; n < neighbour_start[g + 1]; ++n) {
      const Vec4 cone = cones[neighbours[n]];
      if (cone.w >= self_contact_tuning::widest_cone ||
          dot(axis, cone.xyz()) <= cosf(self_contact_tuning::widest_cone - cone.w))
        return false;
    }
    return true;
  }
  /// Whether a pair, first ≤ second, is left out.
  MENISCUS_HD bool has_in_sheet(uint32_t first, uint32_t second) const {
    if (!smooth[first]) return false;
    for (uint32_t n = neighbour_start[first]; n < neighbour_start[first + 1]; ++n)
      if (neighbours[n] == second) return true;
    return false;
  }
  /// Whether a normal of a group's triangle, of any length, keeps all smooth surroundings smooth. This needs
  /// no test of the surroundings.
  MENISCUS_HD bool is_in_cone(uint32_t g, Vec3 n) const {
    const Vec4 cone = cones[g];
    return dot(n, cone.xyz()) >=
           cosf(pbd::min(3.1415927f, cone.w + self_contact_tuning::cone_leeway)) * length(n);
  }
  /// Whether a normal near a smooth group ends its smoothness.
  MENISCUS_HD bool ends_smoothness(uint32_t g, Vec3 n) const {
    return smooth[g] &&
           dot(n, cones[g].xyz()) <
               cosf(self_contact_tuning::widest_cone + self_contact_tuning::cone_leeway) * length(n);
  }
};

MENISCUS_HD inline uint32_t corner_of(const SurfaceTriangle& t, uint32_t k) {
  return k == 0 ? t.a : k == 1 ? t.b : t.c;
}
MENISCUS_HD constexpr uint32_t next_corner(uint32_t k) {
  return k < 2 ? k + 1 : 0;
}
MENISCUS_HD inline bool has_vertex(const SurfaceTriangle& t, uint32_t v) {
  return t.a == v || t.b == v || t.c == v;
}

/// The four vertices of a contact. Bit 31 of the first: two edges.
struct alignas(16) Corners {
  static constexpr uint32_t edges_bit = 1u << 31;

  uint32_t v[4];

  MENISCUS_HD bool edges() const { return (v[0] & edges_bit) != 0; }
  MENISCUS_HD uint32_t vertex(uint32_t k) const { return v[k] & ~edges_bit; }
};

struct ContactWeights {
  float u, v, friction;
};

/// Contacts, as a structure of arrays.
struct ContactList {
  View<Corners> corners;
  View<Vec4> plane;       // normal n, and the distance to be kept
  View<Vec4> multiplier;  // of friction and of the normal push, kg·m
  View<ContactWeights> weights;
  View<uint32_t> counters;

  MENISCUS_HD uint32_t count() const { return listed(corners, counters[contacts]); }
  /// Those of one world, of all.
  MENISCUS_HD ContactList of(uint32_t world, uint32_t each) const {
    return {part_of(corners, world, each), part_of(plane, world, each), part_of(multiplier, world, each),
            part_of(weights, world, each), counters_of(counters, world)};
  }
};

/// The frames of reference of pieces, see frames.h.
struct Frames {
  View<const Vec4> motion;        // by frame, m in a substep; w: how far from that its surroundings move, m
  View<const uint32_t> of_piece;  // by piece
  View<const uint32_t> piece;     // by vertex

  MENISCUS_HD Vec4 at_piece(uint32_t p) const { return motion[of_piece[p]]; }
  MENISCUS_HD Vec4 at(uint32_t v) const { return at_piece(piece[v]); }
  MENISCUS_HD bool differ(uint32_t v, uint32_t w) const { return of_piece[piece[v]] != of_piece[piece[w]]; }
};

/// The vertices of a substep, and the tables of the surface.
struct ClothState {
  View<const Vec4> previous, position;  // by vertex
  MotionBounds kept;
  pbd::SurfaceTreeView tree;
  View<const uint16_t> features;
  View<const PieceProperties> pieces;
  View<const uint32_t> rough;  // by group: whether it is bent so much that its edges stand out
  Frames frames;
  OfWorld of_world;

  /// The vertices of a pair of features.
  MENISCUS_HD Corners corners_of(FeatureCode code) const {
    const SurfaceTriangle s = load(tree.triangles, code.first_place()),
                          t = load(tree.triangles, code.second_place());
    const uint32_t a = code.first & 7, b = code.second & 7;
    if (b == face) return {corner_of(s, a), t.a, t.b, t.c};
    return {corner_of(s, a - 3) | Corners::edges_bit, corner_of(s, next_corner(a - 3)), corner_of(t, b - 3),
            corner_of(t, next_corner(b - 3))};
  }
};

/// The motion of the pair from `from` to `to`, relative to the start of its first vertex.
MENISCUS_HD inline FeaturePair pair_of(const Corners& corners, View<const Vec4> from, View<const Vec4> to) {
  FeaturePair pair;
  pair.edges = corners.edges();
  const Vec3 origin = load(from, corners.vertex(0)).xyz();
  MENISCUS_UNROLL
  for (uint32_t k = 0; k < 4; ++k) {
    const uint32_t v = corners.vertex(k);
    const Vec3 x = load(from, v).xyz();
    pair.start[k] = x - origin;
    pair.motion[k] = to[v].xyz() - x;
  }
  return pair;
}

}  // namespace meniscus::cloth::self_contact_kernels
