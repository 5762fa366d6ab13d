// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How far each vertex may go along its own motion, whatever all others do.
#pragma once

#include "cloth/self_contact/views.h"

namespace meniscus::cloth::self_contact_kernels {

/// The motion in its frame that the solve gave each vertex, and the fraction of it that keeps every pair
/// apart. Half-way between the two features of a pair stands a plane, normal to the shortest line between
/// them at the start of the substep. While each vertex stays on its side of its planes, no pair can meet.
/// Motion along a plane or away from it is free. As each vertex is bounded alone, one that is shut in does
/// not hold others (Chen et al. 2025, Offset Geometric Contact, bound vertices by distances).
struct OwnMotion {
  View<Vec4> solved;        // by vertex: the position after the solve
  View<uint32_t> fraction;  // by vertex: of the motion to there, in units of 1/whole

  static constexpr uint32_t whole = 1u << 24;

  MENISCUS_HD void begin(uint32_t v, Vec4 x) const {
    solved[v] = x;
    fraction[v] = whole;
  }
  /// The safe displacement of a vertex, m. `from`: where the substep began; `frame`: the displacement of its
  /// frame.
  MENISCUS_HD Vec3 displacement(uint32_t v, Vec3 from, Vec3 frame) const {
    return frame +
           static_cast<float>(fraction[v]) / static_cast<float>(whole) * (solved[v].xyz() - from - frame);
  }
  MENISCUS_HD void hold(const Corners& corners) const {
    for (uint32_t k = 0; k < 4; ++k) pbd::atomic_min(fraction[corners.vertex(k)], 0);
  }
  /// Bounds the vertices of a pair, so that it comes no nearer than the mean of `gap` and the present
  /// distance. `at_start`: its nearest points at the start of the substep. The planes move with the frame of
  /// the pair. If its frames differ and it meets, the step is repeated in one frame.
  MENISCUS_HD void part(const Corners& corners, const FeaturePair& pair, View<const Vec4> from,
                        const Frames& frames, const Nearest& at_start, float gap) const {
    const float d = at_start.distance, keep = 0.25f * (gap + d);
    const Vec3 away = at_start.r / d;
    const int second = pair.edges ? 2 : 1;
    const Vec3 on_first =
        pair.edges ? pair.start[0] + at_start.u * (pair.start[1] - pair.start[0]) : pair.start[0];
    for (int k = 0; k < 4; ++k) {
      const uint32_t v = corners.vertex(k);
      const Vec3 side = k < second ? away : -away;
      const float approach = -dot(side, solved[v].xyz() - from[v].xyz() - frames.at(v).xyz());
      if (!(approach > 0)) continue;
      // All of a feature is as far from the plane as its nearest point, or further.
      const float from_nearest = dot(side, pair.start[k] - on_first) + (k < second ? 0 : d);
      const float room = pbd::max(0, from_nearest) + 0.5f * d - keep;
      if (room >= approach) continue;
      pbd::atomic_min(fraction[v], static_cast<uint32_t>(room / approach * static_cast<float>(whole)));
    }
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
