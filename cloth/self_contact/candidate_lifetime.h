// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The candidate lifetime: how long lists of pairs are kept, and the motion bounds of vertices meanwhile.
#pragma once

#include "cloth/self_contact/folds.h"
#include "cloth/self_contact/tuning.h"

namespace meniscus::cloth::self_contact_kernels {

/// The number of elements that the lists have room for.
struct Room {
  uint32_t group_pairs, candidates, contacts;

  MENISCUS_HD bool sufficed(View<const uint32_t> found) const {
    return found[Counter::group_pairs] <= group_pairs && found[Counter::candidates] <= candidates &&
           found[Counter::contacts] <= contacts;
  }
};

/// Stores the predicted position of each vertex, and checks whether the lists of pairs still hold for it. The
/// vertex must stay inside its motion bound. The check adds room for the motion by the solve and for the
/// thickness.
struct Foresee {
  static constexpr float room_for_thickness = 0.5f * self_contact_tuning::reach;  // of two vertices, together

  View<const Vec4> previous, position;  // by vertex
  View<const uint32_t> vertex_piece;
  View<const PieceProperties> pieces;
  View<const float> strayed;    // m, in the last substep
  View<const Vec4> kept, wide;  // motion bounds, see CandidateLifetime
  View<Vec4> foreseen;          // w: the room, m
  ImpactZones impact_zones;
  PieceSums sums;
  Folds folds;
  View<uint32_t> entries, counters;
  Room room_for;
  bool anew;                   // search in any case
  bool begin_for_one_substep;  // if anew: search for one substep only, see CandidateLifetime

  MENISCUS_HD void operator()(uint32_t v) const {
    if (vertex_piece[v] != no_index) foresee(v);
    impact_zones.begin(v);
    folds.begin(v, vertex_piece.count);
    for (uint32_t piece = v; piece < pieces.count; piece += vertex_piece.count) sums.begin(piece);
    entries[v] = 0;
    if (v != 0) return;
    if (anew) {
      counters[listings] = counters[one_substep_listings] = counters[overflowed] = 0;
      counters[long_expired] = counters[age] = begin_for_one_substep;
    } else if (!room_for.sufficed(counters)) {
      counters[overflowed] = 1;
    }
    counters[contacts] = counters[lost] = 0;
    for (uint32_t round = 0; round < most_rounds; ++round) counters[crossings + round] = 0;
  }

  MENISCUS_HD void foresee(uint32_t v) const {
    const Vec3 x = position[v].xyz(), displacement = x - previous[v].xyz();
    const float thickness = pieces[vertex_piece[v]].thickness;
    const float room = room_for_thickness * thickness +
                       self_contact_tuning::room_of_motion * length(displacement) +
                       self_contact_tuning::room_of_strayed * strayed[v];
    foreseen[v] = pbd::with_w(x, room);
    if (anew || leaves(kept[v], x, room)) pbd::atomic_max(counters[expired], 1);
    if (!anew && leaves(wide[v], x, room)) pbd::atomic_max(counters[long_expired], 1);
  }

 private:
  MENISCUS_HD static bool leaves(const Vec4& bound, Vec3 x, float room) {
    return length(x - bound.xyz()) + room > bound.w;
  }
};

/// Whether the pairs are to be listed again: where the lists have expired. A step that will be repeated lists
/// nothing. With contacts missing, it would find more and more pairs, and make room for them.
struct Listing {
  View<const uint32_t> counters;

  MENISCUS_HD bool wanted() const { return counters[expired] != 0 && counters[overflowed] == 0; }
};

/// Chooses the motion bound of each vertex until the next search: a sphere around its expected motion. Where
/// such bounds did not hold even for the next substep, they are made for this substep alone. There are then
/// far fewer pairs. A vertex whose displacement is not finite gets no valid bound and meets nothing, so that
/// the step fails.
struct CandidateLifetime {
  Listing listing;
  View<const Vec4> previous, foreseen;
  View<const uint32_t> vertex_piece;
  View<const PieceProperties> pieces;
  View<Vec4> kept, wide;  // spheres: centre and radius, m; wide: for many substeps, whichever is kept
  View<uint32_t> counters;

  MENISCUS_HD void operator()(uint32_t v) const {
    if (!listing.wanted()) return;
    if (vertex_piece[v] != no_index) keep(v);
    if (v != 0) return;
    counters[group_pairs] = counters[candidates] = 0;
    ++counters[listings];
    if (is_for_one_substep()) ++counters[one_substep_listings];
  }

  MENISCUS_HD void keep(uint32_t v) const {
    using namespace self_contact_tuning;
    const Vec3 from = previous[v].xyz(), displacement = foreseen[v].xyz() - from;
    const float thickness = pieces[vertex_piece[v]].thickness, far = length(displacement);
    const float substeps = pbd::clamp(furthest * thickness / pbd::max(far, 1e-30f), 1, longest);
    const float solve = foreseen[v].w - Foresee::room_for_thickness * thickness;
    const float radius =
        0.5f * substeps * far + foreseen[v].w + leeway * thickness + to_and_fro * pbd::max(0, solve);
    wide[v] = sphere(from + 0.5f * substeps * displacement, radius);
    kept[v] = is_for_one_substep() ? sphere(from + 0.5f * displacement, 0.5f * far + foreseen[v].w) : wide[v];
  }

 private:
  MENISCUS_HD bool is_for_one_substep() const { return counters[long_expired] != 0 && counters[age] == 1; }
  MENISCUS_HD static Vec4 sphere(Vec3 centre, float radius) {
    return pbd::with_w(centre, radius < pbd::most_finite ? radius : NAN);
  }
};

/// Boxes around the motion bounds of triangles, for the tree.
struct KeptBoxes {
  Listing listing;
  MotionBounds kept;

  MENISCUS_HD bool wanted() const { return listing.wanted(); }
  MENISCUS_HD Aabb of(uint32_t v) const { return kept.box(v); }
};

}  // namespace meniscus::cloth::self_contact_kernels
