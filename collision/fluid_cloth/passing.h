// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Fluid that passes through permeable cloth by Darcy's law, q = ψ Δp/(ρ g), with the permittivity ψ (1/s) and
// the water column Δp/(ρ g).
//
// Which particle passes is drawn at random, among those that press from the side of the greater pressure. One
// that presses with the force F passes in a substep with the probability ψ F hₜ/(ρ g s³). This is multiplied
// by the fraction of the push that nothing on the other side withstands. A passing particle meets no
// permeable cloth until it is clear of all, on whichever side the pressure has moved it to.
#pragma once

#include "collision/fluid_cloth/find.h"
#include "collision/fluid_cloth/load.h"
#include "collision/fluid_cloth/tuning.h"
#include "pbd/math/random.h"

namespace meniscus::collision::fluid_cloth_kernels {

/// m: a passing particle is clear of cloth at this distance, and one that begins to pass is nearer. The
/// second layer of particles is further away.
MENISCUS_HD inline float clear_of_cloth(float radius) {
  return fluid_cloth_tuning::clear * radius;
}

/// Whether a particle in contact at x may begin to pass.
MENISCUS_HD inline bool is_at_cloth(const pbd::Contact& c, Vec3 x) {
  return plane_distance(c, x) < clear_of_cloth(c.radius);
}

/// Stores the impulse of each contact in the substep, and the part of it on particles at the cloth. These
/// pass for all particles.
struct NotePushes {
  NearList near;
  View<const pbd::Contact> contacts;
  View<const Vec4> position;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n >= most_touches * near.count()) return;
    FluidClothContact& t = near.touches[n];
    t.given = t.pending = {0, 0, 0};
    if (!is_used(t) || t.contact >= contacts.count) return;
    const pbd::Contact& c = contacts[t.contact];
    t.given = multiplier_sum(c);
    if (is_at_cloth(c, position[near.particle[n / most_touches]].xyz())) t.pending = t.given;
  }
};

/// The flow at each vertex: the push that nothing on the other side withstands, over the push of the
/// particles that may pass.
struct DrivePassing {
  LoadedVertices vertices;
  View<Vec4> drive;  // by vertex, towards the greater pressure

  MENISCUS_HD void operator()(uint32_t v) const {
    if (!vertices.any(v)) return;
    const Vec3 net{vertices.sum(v, [](const FluidClothContact& t, float w) { return w * t.given.x; }),
                   vertices.sum(v, [](const FluidClothContact& t, float w) { return w * t.given.y; }),
                   vertices.sum(v, [](const FluidClothContact& t, float w) { return w * t.given.z; })};
    const Vec3 up = normalized_or(net, {0, 0, 0});
    const float greater = vertices.sum(
        v, [&](const FluidClothContact& t, float w) { return w * pbd::max(0, dot(t.pending, up)); });
    if (!VertexTeam::leads()) return;
    drive[v] = greater > 0 ? pbd::with_w(net / greater, 0) : Vec4{0, 0, 0, 0};
  }
};

struct BeginPassing {
  NearList near;
  View<const pbd::Contact> contacts;
  View<const FluidClothPiece> pieces;
  View<const Vec4> drive;  // by vertex
  View<const Vec4> position;
  View<const uint32_t> number;
  View<pbd::Phase> phase;
  uint32_t draw;
  float dt;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= near.count()) return;
    const uint32_t i = near.particle[k];
    float chance = 0;
    for (uint32_t n = 0; n < most_touches; ++n) {
      const FluidClothContact& t = near.touches[most_touches * k + n];
      if (!is_used(t) || t.contact >= contacts.count) continue;
      const pbd::Contact& c = contacts[t.contact];
      if (!is_at_cloth(c, position[i].xyz())) continue;
      const Vec3 driven = t.mean([&](uint32_t v) { return drive[v].xyz(); });
      const float fraction = pbd::max(0, dot(driven, c.normal));
      chance += pieces[t.piece].flow * fraction * pbd::max(0, dot(t.pending, c.normal)) / dt;
    }
    if (TouchTeam::leads() && chance > 0 && pbd::random_numbers(number[i], draw, 0).x < chance)
      phase[i] = (phase[i] | pbd::phase_passing) & ~pbd::phase_pressing;
  }
};

/// Ends the passage of particles that are clear of cloth. Runs before contacts are found.
struct EndPassing {
  Surface surface;
  View<pbd::Phase> phase;
  float largest_radius;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (!(phase[i] & pbd::phase_passing)) return;
    const Vec3 at = surface.previous[i].xyz();
    bool clear = true;
    const Aabb box = motion_box(at, at, clear_of_cloth(largest_radius));
    pbd::for_each_overlap(surface.tree, surface.world_of(i), box, 0, 0, [&](uint32_t place) {
      const pbd::SurfaceTriangle t = load(surface.tree.triangles, place);
      const FluidClothPiece& piece = surface.pieces[t.piece];
      if (piece.flow == 0 || !surface.may_meet(i, t.piece)) return;
      clear = clear && nearest(surface.pair(at, at, t), 0).distance >= clear_of_cloth(piece.radius);
    });
    if (clear) phase[i] &= ~pbd::phase_passing;
  }
};

}  // namespace meniscus::collision::fluid_cloth_kernels
