// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The CCD fail-safe of fluid and cloth: no particle passes through cloth, whatever the solve has left.
#pragma once

#include "collision/fluid_cloth/find.h"
#include "collision/fluid_cloth/tuning.h"

namespace meniscus::collision::fluid_cloth_kernels {

/// Clamps a particle at the time of impact with a triangle that it would have passed through. It then moves
/// along with the triangle, on its own side. Cloth is at its final positions, so each particle is tested
/// alone. The contact corrects the velocity.
struct ClampAtImpact {
  Surface surface;
  View<Vec4> position;
  View<uint32_t> found;  // see Found

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 from = surface.previous[i].xyz(), wanted = position[i].xyz();
    Vec3 to = wanted;
    for (int round = 0;; ++round) {
      const Vec3 end = first_stop(i, from, to, round);
      if (end == to) break;
      if (round == fluid_cloth_tuning::clamp_rounds) {
        pbd::atomic_add(found[unstopped], 1);
        break;
      }
      to = end;
    }
    if (!(to == wanted)) position[i] = pbd::with_w(to, position[i].w);
  }

  /// The end of the motion beside the first triangle that it meets; in later rounds nearer to that triangle.
  MENISCUS_HD Vec3 first_stop(uint32_t i, Vec3 from, Vec3 to, int round) const {
    float first = 2;
    Vec3 stop = to;
    const uint32_t world = surface.world_of(i);
    pbd::for_each_overlap(surface.tree, world, motion_box(from, to, 0), 0, 0, [&](uint32_t place) {
      const pbd::SurfaceTriangle t = load(surface.tree.triangles, place);
      if (!surface.meets(i, t.piece)) return;
      const float radius = surface.pieces[t.piece].radius;
      const pbd::FeaturePair pair = surface.pair(from, to, t);
      const float motion = relative_motion(pair), start = nearest(pair, 0).distance;
      const float gap =
          pbd::min(fluid_cloth_tuning::clamp_gap * start, fluid_cloth_tuning::clamp_gap_of_radius * radius);
      if (start <= 0 || motion < start - gap) return;
      const float time = time_of_nearness(pair, gap);
      if (time >= first) return;
      first = time;
      stop = from + beside(pair, time, radius / static_cast<float>(2 << 2 * round));
    });
    return stop;
  }

  /// The point at the end of the motion beside the place met at that time, no further from it than
  /// `distance`.
  MENISCUS_HD static Vec3 beside(const pbd::FeaturePair& pair, float time, float distance) {
    const pbd::Nearest met = nearest(pair, time);
    const Vec3 point = (1 - met.u - met.v) * pair.at(1, 1) + met.u * pair.at(2, 1) + met.v * pair.at(3, 1);
    const Vec3 away = met.r / pbd::max(met.distance, 1e-30f);
    return point + distance * turned_to_end(pair, away, time);
  }
};

}  // namespace meniscus::collision::fluid_cloth_kernels
