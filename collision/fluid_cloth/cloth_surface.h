// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Triangles of cloth and fluid-cloth contacts, as kernels read them.
#pragma once

#include <meniscus/types.h>

#include <cmath>

#include "pbd/device/teams.h"
#include "pbd/feature_pair.h"
#include "pbd/filter.h"
#include "pbd/particles.h"
#include "pbd/surface_tree/boxes.h"

namespace meniscus::collision {

/// How a piece of cloth interacts with fluid.
struct FluidClothPiece {
  CollisionFilter filter{};
  float radius = 0;    ///< m: particles' centres stop at this distance
  float friction = 0;  ///< Coulomb's μ
  float adhesion = 0;  ///< N: the largest pull on one particle
  float spread = 0;  ///< m: a particle acts on all vertices within this distance; 0: on those of one triangle
  float flow = 0;    ///< 1/(N·s): particles that pass through per second, for each newton of pressing force
  uint32_t absorbs = 0;           ///< 1: it absorbs particles that touch it
  float slip_length = HUGE_VALF;  ///< m, of viscous fluid
};

/// A particle that touches absorbent cloth, and the vertex that is nearest to it.
struct WettingTouch {
  uint32_t slot;  ///< of the particle
  uint32_t vertex;
};

namespace fluid_cloth_kernels {

using pbd::GroupTeam;
using pbd::no_index;
using pbd::SearchTeam;
using pbd::Vec4;
using pbd::View;
/// Works on the fluid-cloth contacts of one particle.
using TouchTeam = pbd::Team<8>;

/// The surface of all cloth, at the substep's start and at its present positions.
struct Surface {
  pbd::SurfaceTreeView tree;
  View<const Vec4> previous, position;  // of all particles
  uint32_t first_vertex;                // vertex v is particle first_vertex + v
  View<const FluidClothPiece> pieces;
  View<const uint32_t> marks;            // by place in the tree: see triangle_marks()
  View<const CollisionFilter> by_fluid;  // empty where all collide with everything
  View<const pbd::Phase> phase;          // of all particles
  uint32_t each;                         // particles of fluids, of a world

  MENISCUS_HD uint32_t world_of(uint32_t i) const { return i / each; }
  /// Whether particle i collides with the piece.
  MENISCUS_HD bool meets(uint32_t i, uint32_t piece) const {
    return !((phase[i] & pbd::phase_passing) && pieces[piece].flow > 0) && may_meet(i, piece);
  }
  /// The same for a particle that is not passing through.
  MENISCUS_HD bool may_meet(uint32_t i, uint32_t piece) const {
    const CollisionFilter filter = by_fluid.count ? by_fluid[pbd::phase_group(phase[i])] : CollisionFilter{};
    return pbd::meet(pieces[piece].filter, filter);
  }

  MENISCUS_HD Vec3 start(uint32_t v) const { return load(previous, first_vertex + v).xyz(); }
  MENISCUS_HD Vec3 end(uint32_t v) const { return load(position, first_vertex + v).xyz(); }

  /// The motions of a particle and a triangle, both relative to the particle's start.
  MENISCUS_HD pbd::FeaturePair pair(Vec3 from, Vec3 to, const pbd::SurfaceTriangle& t) const {
    pbd::FeaturePair pair;
    const uint32_t corner[3] = {t.a, t.b, t.c};
    pair.start[0] = {0, 0, 0};
    pair.motion[0] = to - from;
    for (int k = 0; k < 3; ++k) {
      const Vec3 x = start(corner[k]);
      pair.start[k + 1] = x - from;
      pair.motion[k + 1] = end(corner[k]) - x;
    }
    return pair;
  }
};

/// The unit normal of a pair's triangle at time t, 0 to 1.
MENISCUS_HD inline Vec3 face_normal(const pbd::FeaturePair& p, float t) {
  const Vec3 a = p.at(1, t);
  return normalized_or(cross(p.at(2, t) - a, p.at(3, t) - a), {0, 0, 0});
}

/// A unit direction away from a triangle at time t, after it has turned with the triangle until the end.
MENISCUS_HD inline Vec3 turned_to_end(const pbd::FeaturePair& p, Vec3 direction, float t) {
  const Vec3 n = face_normal(p, t), turned = direction + dot(direction, n) * (face_normal(p, 1) - n);
  return normalized_or(turned, direction);
}

/// A particle near cloth. It has a contact for each layer of cloth near it, at most three. The corners of the
/// triangle that it touches share its push. In a mesh finer than the particles, all vertices within a spacing
/// share it, at most 32.
struct alignas(16) FluidClothContact {
  static constexpr uint32_t most_vertices = 32;

  Vec3 point;         ///< m, on the surface
  uint32_t vertices;  ///< the number of vertices that share it; 0: no contact
  Vec3 normal;        ///< unit, towards the particle
  float fraction;     ///< see pbd::Contact
  uint32_t piece;
  uint32_t contact;        ///< its number among all contacts
  float carried_fraction;  ///< of the particle that the sheet carries: 1 over the number of sheets that do
  float carried;           ///< kg, the same
  Vec3 followed;           ///< m: how far the sheet had been moved here when the contact last followed it
  Vec3 given;              ///< kg·m: what the vertices have got back so far, of what the contact has pushed
  Vec3 pending;            ///< kg·m: what they are to get back now
  uint32_t vertex[most_vertices];
  float weight[most_vertices];  ///< their sum is 1

  MENISCUS_HD void add(uint32_t v, float w) { set(vertices++, v, w); }
  /// A new contact that nothing has acted on. Its vertices are set.
  MENISCUS_HD void begin(Vec3 at, Vec3 towards, float of_plane, uint32_t of_piece, uint32_t count) {
    point = at;
    vertices = count;
    normal = towards;
    fraction = of_plane;
    piece = of_piece;
    contact = no_index;
    carried_fraction = carried = 0;
    followed = given = pending = {0, 0, 0};
  }
  MENISCUS_HD void set(uint32_t k, uint32_t v, float w) {
    vertex[k] = v;
    weight[k] = w;
  }
  /// Σ weight · of(vertex), computed by a team.
  template <class Of>
  MENISCUS_HD Vec3 mean(const Of& of) const {
    Vec3 sum{0, 0, 0};
    for (uint32_t k = TouchTeam::rank(); k < vertices; k += TouchTeam::count())
      sum += weight[k] * of(vertex[k]);
    return TouchTeam::sum(sum);
  }
};

inline constexpr uint32_t most_touches = 3;

/// What the host reads of a step: the greatest number of particles near cloth in a substep, and what exceeded
/// a fixed size, summed over the substeps.
enum Found : uint32_t {
  near_cloth,
  crowded,    // particles with more than most_touches layers
  cut,        // contacts with more than FluidClothContact::most_vertices vertices
  unstopped,  // particles that ClampAtImpact did not stop
  found_count
};

MENISCUS_HD inline bool is_used(const FluidClothContact& t) {
  return t.vertices > 0;
}

/// The particles that are near cloth, in no order, and their contacts. Those of entry k start at most_touches
/// · k.
struct NearList {
  View<uint32_t> particle;
  View<FluidClothContact> touches;
  View<uint32_t> counter;  // the number of particles near cloth, which may be more than fit

  MENISCUS_HD uint32_t count() const { return counter[0] < particle.count ? counter[0] : particle.count; }
};

}  // namespace fluid_cloth_kernels

}  // namespace meniscus::collision
