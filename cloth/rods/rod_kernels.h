// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of RodSet. An iteration linearizes the constraints of each segment, solves for the increments
// of the multipliers rod by rod, and moves vertices and frames by them.
#pragma once

#include "cloth/rods/linearize.h"
#include "cloth/solve/push_vertex.h"

namespace meniscus::cloth::rod_kernels {

/// Takes the motion from a segment.
struct Stop {
  pbd::View<pbd::Vec4> frame, previous, spin;

  MENISCUS_HD void operator()(uint32_t k) const {
    frame[k] = previous[k] = vec4(normalized(quat(frame[k])));
    spin[k] = pbd::with_w({0, 0, 0}, spin[k].w == 0 ? 0.0f : 1.0f);
  }
};

/// q + h ω: predicts the frames.
struct Advance {
  View<Vec4> frame, previous;
  View<const Vec4> spin;
  float dt;

  MENISCUS_HD void operator()(uint32_t k) const {
    const Quat q = quat(frame[k]);
    previous[k] = frame[k];
    frame[k] = vec4(normalized(rotation_by(dt * spin[k].xyz()) * q));
  }
};

/// Resets the multipliers, and stores the strains that damping is measured from.
struct Begin {
  RodView rods;

  MENISCUS_HD void operator()(uint32_t k) const {
    const RodSegment s = rods.segment[k];
    const uint32_t first = rods.particles.sorted;
    const Quat q = quat(rods.previous[k]);
    const Vec3 apart =
        rods.particles.previous[first + s.b].xyz() - rods.particles.previous[first + s.a].xyz();
    Strain start{stretch_strain(rotate(conjugate(q), apart), s.rest_length), {0, 0, 0}};
    if (s.after != pbd::no_index)
      start.bend =
          rotation_vector(relative_frame(q, quat(rods.previous[s.after]), s.rest)) - rotation_vector(s.rest);
    rods.start[k] = start;
    rods.multiplier[k] = {{0, 0, 0}, {0, 0, 0}};
    rods.torque[k] = {0, 0, 0, 0};
  }
};

/// Solves a rod in each thread.
struct Solve {
  View<const RodChain> chain;
  View<BandRow> rows;
  int iteration;

  MENISCUS_HD void operator()(uint32_t i) const {
    const RodChain c = chain[i];
    if (!c.closed) return solve_band(rows, {c, 0});
    const uint32_t cut = iteration % 2 ? c.count / 2 : 0;
    const uint32_t left_out = c.first + (cut + c.count - 1) % c.count;
    solve_band(rows, {c, cut});
    rows[2 * left_out].right = {0, 0, 0};
    rows[2 * left_out + 1].right = {0, 0, 0};
  }
};

/// x += W Jᵀ Δλ. The thread of a segment moves its frame and its first vertex. That of the last segment moves
/// both vertices.
struct Apply {
  RodView rods;

  MENISCUS_HD void operator()(uint32_t k) const {
    const RodSegment s = rods.segment[k];
    const Vec3 pull = rods.rows[2 * k].right;
    const Link link = rods.link[k];
    const Quat q = quat(rods.frame[k]);
    Vec3 push = -pull;
    Vec3 torque = cross(rotate(conjugate(q), pull), link.reach);
    Vec3 bend{0, 0, 0};
    if (s.before != pbd::no_index) {
      push += rods.rows[2 * s.before].right;
      torque += transposed_times(rods.link[s.before].bend, rods.rows[2 * s.before + 1].right);
    }
    if (s.after != pbd::no_index) {
      bend = rods.rows[2 * k + 1].right;
      torque += -(link.bend * bend);
    } else {
      push_vertex(rods.particles, s.b, pull);
    }
    push_vertex(rods.particles, s.a, push);
    const Vec3 w = mobility(rods, k);
    const Quat turn = rotation_by({w.x * torque.x, w.y * torque.y, w.z * torque.z});
    rods.frame[k] = vec4(normalized(q * turn));
    rods.torque[k] = pbd::with_w(rods.torque[k].xyz() + rotate(q, torque), 0);
    Strain& multiplier = rods.multiplier[k];
    multiplier = {multiplier.stretch + pull, multiplier.bend + bend};
    rods.pull[k] = pbd::max(0.0f, -dot(multiplier.stretch, rotate(q, {0, 0, 1})));
  }
};

/// Sets ω to the rotation of the frame in the substep.
struct UpdateSpin {
  View<const Vec4> frame, previous;
  View<Vec4> spin;
  float inverse_dt;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (spin[k].w == 0) return;
    const Quat turn = relative_frame(conjugate(quat(frame[k])), conjugate(quat(previous[k])), {0, 0, 0, 1});
    spin[k] = pbd::with_w(inverse_dt * rotation_vector(turn), 1);
  }
};

}  // namespace meniscus::cloth::rod_kernels
