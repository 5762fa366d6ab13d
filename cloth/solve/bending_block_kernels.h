// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels that solve isometric bending as one block (bending_solver.h), by Chebyshev's semi-iteration.
#pragma once

#include "cloth/solve/bending_matrix.h"
#include "cloth/solve/tuning.h"
#include "cloth/solve/vertex_state.h"

namespace meniscus::cloth::bending_block_kernels {

/// τ/h, damped as xpbd_step() does: in proportion to the stiffness that a single hinge would have.
MENISCUS_HD inline float damping_of(const BendingRate& rate, float dt) {
  return rate.damping > 0 ? rate.damping / (dt * (1 + dt * dt * rate.typical)) : 0;
}
/// The greatest eigenvalue, or a little more than the least.
MENISCUS_HD inline float fastest_of(const BendingRate& rate, float dt) {
  const float last = 1 + dt * dt * (1 + damping_of(rate, dt)) * rate.fastest;
  return last > 1.01f ? last : 1.01f;
}

/// What Chebyshev's polynomial of a degree leaves of a mode with eigenvalue λ: T((m − λ)/s)/T(m/s), with T of
/// that degree and λ up to m + s. Slow modes have λ near 1, and they are the ones that shape cloth. So the
/// first root lies at λ = 1. The other modes keep errors of either sign, of which no more than a third is
/// stable: z² = p (2z − 1) holds no p below −1/3. If the degree is too low for that, the root moves up.
struct Polynomial {
  float middle, half;
  bool holds_all;  ///< whether the first root lies at 1
  uint32_t degree;

  MENISCUS_HD Polynomial(float last, uint32_t count) : degree(count) {
    const float error = cloth_tuning::bending_error, root = cosf(1.5707964f / static_cast<float>(count));
    const float reach = acoshf(1 / error) / static_cast<float>(count);
    half = (last - 1) / (1 + root);
    holds_all = acoshf(root + 1 / half) >= reach;
    if (!holds_all) half = last / (1 + coshf(reach));
    middle = last - half;
  }
  /// Of the stiffness of slow modes, the part that is had.
  MENISCUS_HD float fraction() const {
    if (holds_all) return 1;
    const float x = (middle - 1) / half, n = static_cast<float>(degree);
    const float t = x > 1 ? coshf(n * acoshf(x)) : cosf(n * acosf(x));
    return 1 - cloth_tuning::bending_error * t;
  }
};

/// One step of the iteration: P ← P + a r + b (P − P of the step before).
struct Step {
  float a, b;
};

/// What a piece solves with in this substep.
struct PieceBending {
  float damping;    ///< γ
  float stiffness;  ///< h² (1 + γ), s²
};

/// The steps of each piece (Saad, Iterative Methods for Sparse Linear Systems, algorithm 12.1).
struct Plan {
  View<const BendingRate> rates;
  float dt;
  uint32_t count;
  View<Step> steps;  ///< by piece, most_bending_steps each
  View<PieceBending> pieces;

  MENISCUS_HD void operator()(uint32_t p) const {
    const BendingRate rate = rates[p];
    const float gamma = damping_of(rate, dt);
    pieces[p] = {gamma, dt * dt * (1 + gamma)};
    const Polynomial of(fastest_of(rate, dt), count);
    const View<Step> out = steps.from(p * cloth_tuning::most_bending_steps);
    float before = of.half / of.middle;
    out[0] = {1 / of.middle, 0};
    for (uint32_t k = 1; k < count; ++k) {
      const float now = 1 / (2 * of.middle / of.half - before);
      out[k] = {2 * now / of.half, now * before};
      before = now;
    }
  }
};

/// The matrix Q on the device.
struct MatrixView {
  View<const uint32_t> slice_start, column;
  View<const float> value;

  /// Row i of Q times x, where at(j) is x_j.
  template <class At>
  MENISCUS_HD Vec3 times(uint32_t i, const At& at) const {
    constexpr uint32_t slice = BendingMatrix::slice;
    const uint32_t end = slice_start[i / slice + 1];
    const Vec4 self = at(i);
    Vec4 sum{0, 0, 0, 0};
    for (uint32_t n = slice_start[i / slice] + i % slice; n < end; n += slice)
      sum = plus(sum, load(value, n), plus(at(load(column, n)), -1, self));
    return sum.xyz();
  }
};

/// What both kernels use.
struct Block {
  MatrixView matrix;
  VertexState vertices;
  View<const Step> steps;
  View<const PieceBending> pieces;
  View<Vec4> right;  ///< kg·m

  MENISCUS_HD Step step(uint32_t piece, uint32_t k) const {
    return steps[piece * cloth_tuning::most_bending_steps + k];
  }
};

/// The right side −h² Q (x + γ (x − x₀)), and the first step.
struct Start {
  Block block;
  View<Vec4> next;  ///< w: the inverse mass

  MENISCUS_HD void operator()(uint32_t i) const {
    const VertexState& v = block.vertices;
    const uint32_t piece = v.piece_number(i);
    const float gamma = block.pieces[piece].damping, dt = 1 / v.inverse_dt;
    const Vec3 force = gamma > 0 ? block.matrix.times(i,
                                                      [&](uint32_t j) {
                                                        const Vec4 x = v.position(j);
                                                        return plus(x, gamma, plus(x, -1, v.previous(j)));
                                                      })
                                 : block.matrix.times(i, [&](uint32_t j) { return v.position(j); });
    const Vec3 right = -dt * dt * force;
    block.right[i] = pbd::with_w(right, 0);
    next[i] = pbd::with_w(block.step(piece, 0).a * right, v.position(i).w);
  }
};

/// Step k. `next` holds what `from` was one step before. The last step moves the vertex.
struct Continue {
  Block block;
  View<const Vec4> from;
  View<Vec4> next;
  uint32_t k;
  bool ends;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t piece = block.vertices.piece_number(i);
    const Step step = block.step(piece, k);
    const Vec4 now = from[i];
    const Vec3 force = block.matrix.times(i, [&](uint32_t j) {
      const Vec4 p = load(from, j);
      return Vec4{p.w * p.x, p.w * p.y, p.w * p.z, p.w * p.w};  // four at once; w is of no use
    });
    const Vec3 residual = block.right[i].xyz() - now.xyz() - block.pieces[piece].stiffness * force;
    const Vec3 change = k > 1 ? now.xyz() - next[i].xyz() : now.xyz();
    const Vec3 after = now.xyz() + step.a * residual + step.b * change;
    if (ends) {
      block.vertices.push(i, block.vertices.at(i), after);
    } else {
      next[i] = pbd::with_w(after, now.w);
    }
  }
};

}  // namespace meniscus::cloth::bending_block_kernels
