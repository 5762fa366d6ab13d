// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The candidate lifetime: how long lists of pairs are kept, and the motion bounds of vertices meanwhile.
#pragma once

#include "cloth/self_contact/folds.h"
#include "cloth/self_contact/frames.h"
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

/// The room that a vertex needs around its predicted position: for the thickness, and for the motion by the
/// solve.
struct RoomOfVertex {
  static constexpr float for_thickness = 0.5f * self_contact_tuning::reach;  // of two vertices, together

  float thickness, solve;  // m

  /// `displacement` relative to the frame, `strayed` in the last substep.
  MENISCUS_HD RoomOfVertex(float thickness_, const Vec4& frame, Vec3 displacement, float strayed)
      : thickness(thickness_),
        solve(self_contact_tuning::room_of_motion * length(displacement) +
              self_contact_tuning::room_of_strayed * strayed + frame.w) {}
  MENISCUS_HD float whole() const { return for_thickness * thickness + solve; }
};

/// Stores the predicted position of each vertex, and checks whether the lists of pairs still hold for it. The
/// vertex must stay inside its motion bound, which moves on with its frame. The check adds room for the
/// motion by the solve and for the thickness.
struct Foresee {
  View<const Vec4> previous, position;  // by vertex
  View<const uint32_t> vertex_piece;
  View<const PieceProperties> pieces;
  View<const float> strayed;  // m, in the last substep
  Frames frames;
  Surroundings around;
  View<Vec4> kept, wide;  // motion bounds, see CandidateLifetime
  View<Vec4> foreseen;    // w: the room, m
  ImpactZones impact_zones;
  PieceSums sums;
  Folds folds;
  View<uint32_t> entries, all_counters;
  OfWorld of_world;
  Room room_for;                              // of a world
  bool anew;                                  // search in any case
  View<const uint8_t> begin_for_one_substep;  // by world; if anew: search for one substep only, see
                                              // CandidateLifetime

  MENISCUS_HD void operator()(uint32_t v) const {
    const uint32_t world = v / of_world.vertices, thread = v % of_world.vertices;
    const View<uint32_t> counters = counters_of(all_counters, world);
    if (vertex_piece[v] != no_index) foresee(v, counters);
    impact_zones.begin(v);
    folds.begin(world, thread, of_world.vertices);
    for (uint32_t k = thread; k < of_world.pieces; k += of_world.vertices) {
      const uint32_t piece = world * of_world.pieces + k;
      sums.begin(piece);
      const float margin = self_contact_tuning::leeway * pieces[piece].thickness;
      if (!anew && !around.suits(piece, frames.at_piece(piece), margin))
        pbd::atomic_max(counters[expired], 1);
    }
    entries[v] = 0;
    if (thread != 0) return;
    if (anew) {
      counters[listings] = counters[one_substep_listings] = counters[overflowed] = 0;
      counters[frames_meet] = counters[cells_meet] = 0;
      counters[long_expired] = counters[age] = begin_for_one_substep[world];
    } else {
      if (!room_for.sufficed(counters)) counters[overflowed] = 1;
      if (counters[several_frames] != 0) pbd::atomic_max(counters[expired], 1);
    }
    counters[several_frames] = 0;
    counters[contacts] = counters[lost] = 0;
    for (uint32_t round = 0; round < most_rounds; ++round) counters[crossings + round] = 0;
  }

  MENISCUS_HD void foresee(uint32_t v, View<uint32_t> counters) const {
    const Vec3 x = position[v].xyz(), displacement = x - previous[v].xyz();
    const Vec4 frame = frames.at(v);
    const float room =
        RoomOfVertex(pieces[vertex_piece[v]].thickness, frame, displacement - frame.xyz(), strayed[v])
            .whole();
    foreseen[v] = pbd::with_w(x, room);
    if (anew) {  // no bounds are known
      pbd::atomic_max(counters[expired], 1);
      return;
    }
    kept[v] = pbd::shifted(kept[v], frame.xyz());
    wide[v] = pbd::shifted(wide[v], frame.xyz());
    if (leaves(kept[v], x, room)) pbd::atomic_max(counters[expired], 1);
    if (leaves(wide[v], x, room)) pbd::atomic_max(counters[long_expired], 1);
  }

 private:
  MENISCUS_HD static bool leaves(const Vec4& bound, Vec3 x, float room) {
    return length(x - bound.xyz()) + room > bound.w;
  }
};

/// Whether the pairs are to be listed again: where the lists have expired. A step that will be repeated lists
/// nothing. With contacts missing, it would find more and more pairs, and make room for them.
struct Listing {
  View<const uint32_t> counters;  // of all worlds

  MENISCUS_HD bool wanted(uint32_t world) const {
    const View<const uint32_t> own = counters_of(counters, world);
    return own[expired] != 0 && own[overflowed] == 0;
  }
};

/// Chooses the motion bound of each vertex until the next search: a sphere around its expected motion, in the
/// frame of its piece. Where such bounds did not hold even for the next substep, they are made for this
/// substep alone. There are then far fewer pairs. A vertex whose displacement is not finite gets no valid
/// bound and meets nothing, so that the step fails.
struct CandidateLifetime {
  Listing listing;
  View<const Vec4> previous;
  View<Vec4> foreseen;
  View<const uint32_t> vertex_piece, frame_of;
  View<const PieceProperties> pieces;
  View<const float> strayed;
  Surroundings around;
  View<Vec4> frames;      // chosen here
  View<Vec4> kept, wide;  // spheres: see MotionBounds; wide: for many substeps, whichever is kept
  View<uint32_t> all_counters;
  OfWorld of_world;

  MENISCUS_HD void operator()(uint32_t v) const {
    const uint32_t world = v / of_world.vertices, thread = v % of_world.vertices;
    if (!listing.wanted(world)) return;
    const View<uint32_t> counters = counters_of(all_counters, world);
    if (vertex_piece[v] != no_index) keep(v, counters);
    for (uint32_t k = thread; k < of_world.frames; k += of_world.vertices) {
      const uint32_t f = world * of_world.frames + k;
      frames[f] = around.frame(pieces.count + f);
    }
    if (thread != 0) return;
    counters[group_pairs] = counters[candidates] = 0;
    ++counters[listings];
    if (is_for_one_substep(counters)) ++counters[one_substep_listings];
  }

  MENISCUS_HD void keep(uint32_t v, View<const uint32_t> counters) const {
    using namespace self_contact_tuning;
    // Not read from `frames`, which other threads write.
    const Vec4 frame = around.frame(pieces.count + frame_of[vertex_piece[v]]);
    const Vec3 moved = previous[v].xyz() + frame.xyz(), displacement = foreseen[v].xyz() - moved;
    const float thickness = pieces[vertex_piece[v]].thickness, far = length(displacement);
    const RoomOfVertex room(thickness, frame, displacement, strayed[v]);
    foreseen[v] = pbd::with_w(foreseen[v].xyz(), room.whole());
    const float substeps = pbd::clamp(furthest * thickness / pbd::max(far, 1e-30f), 1, longest);
    const float radius = 0.5f * substeps * far + room.whole() + leeway * thickness + to_and_fro * room.solve;
    wide[v] = sphere(moved + 0.5f * substeps * displacement, radius);
    kept[v] = is_for_one_substep(counters) ? sphere(moved + 0.5f * displacement, 0.5f * far + room.whole())
                                           : wide[v];
  }

 private:
  MENISCUS_HD static bool is_for_one_substep(View<const uint32_t> counters) {
    return counters[several_frames] != 0 || (counters[long_expired] != 0 && counters[age] == 1);
  }
  MENISCUS_HD static Vec4 sphere(Vec3 centre, float radius) {
    return pbd::with_w(centre, radius < pbd::most_finite ? radius : NAN);
  }
};

/// Boxes around the motion bounds of triangles at the end of this substep, for the tree.
struct KeptBoxes {
  Listing listing;
  MotionBounds kept;

  MENISCUS_HD bool wanted(uint32_t world) const { return listing.wanted(world); }
  MENISCUS_HD Aabb of(uint32_t v) const { return kept.box(v); }
};

/// The same at its start, where frames differ.
struct KeptBoxesBefore {
  Listing listing;
  MotionBounds kept;
  Frames frames;

  MENISCUS_HD bool wanted(uint32_t world) const {
    return listing.wanted(world) && counters_of(listing.counters, world)[several_frames] != 0;
  }
  MENISCUS_HD Aabb of(uint32_t v) const {
    const Vec3 motion = frames.at(v).xyz();
    const Aabb box = kept.box(v);
    return {box.lower - motion, box.upper - motion};
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
