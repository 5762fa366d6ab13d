// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The gas in closed pieces of cloth. At constant temperature p V is constant. The gas would fill the volume
// V_u without strain. Near V_u the overpressure is (V_u − V)/α. This is a constraint C = V − V_u with
// compliance α, whose multiplier is minus the overpressure. It acts on all vertices at once.
#pragma once

#include "cloth/solve/vertex_state.h"
#include "pbd/surface_tree/surface.h"

namespace meniscus::cloth::volume_kernels {

inline constexpr uint32_t lanes = 64;  ///< the number of strided partial sums of a piece

/// Of one piece: V, Σ w|∇V|², Σ ∇V·(x − x₀) and the multiplier so far in the substep.
struct GasState {
  float volume, weight, rate;
  float multiplier;  ///< kg/m·s⁰: over h² it is a pressure, Pa
};

/// ∇V at each vertex of a piece with gas: a sixth of Σ x_j × x_k over its triangles. Positions are taken
/// relative to the first vertex of the piece. Relative to a distant origin, only rounding would be left.
struct Gradients {
  View<const pbd::SurfaceTriangle> triangles;
  View<const uint32_t> corner_start, corners;
  VertexState vertices;
  View<Vec4> gradient;  ///< m²; w: the vertex's contribution to V, m³

  MENISCUS_HD void operator()(uint32_t v) const {
    const Piece& piece = vertices.piece_of(v);
    if (piece.inside == 0) return;
    const Vec3 origin = vertices.position(piece.first_vertex).xyz();
    Vec3 sum{0, 0, 0};
    for (uint32_t k = corner_start[v]; k < corner_start[v + 1]; ++k) {
      const pbd::SurfaceTriangle t = triangles[corners[k] / 3];
      const uint32_t corner = corners[k] % 3;
      const uint32_t next = corner == 0 ? t.b : corner == 1 ? t.c : t.a;
      const uint32_t last = corner == 0 ? t.c : corner == 1 ? t.a : t.b;
      sum += cross(vertices.position(next).xyz() - origin, vertices.position(last).xyz() - origin);
    }
    const Vec3 g = (1.0f / 6) * sum;
    gradient[v] = pbd::with_w(g, (1.0f / 3) * dot(vertices.position(v).xyz() - origin, g));
  }
};

/// One partial sum of one piece.
struct SumLanes {
  View<const Vec4> gradient;
  VertexState vertices;
  View<GasState> partial;

  MENISCUS_HD void operator()(uint32_t n) const {
    const Piece& piece = vertices.pieces[n / lanes];
    GasState sum{0, 0, 0, 0};
    if (piece.inside > 0) {
      for (uint32_t v = piece.first_vertex + n % lanes; v < piece.end_vertex; v += lanes) {
        const Vec4 g = gradient[v], x = vertices.position(v);
        sum.volume += g.w;
        sum.weight += x.w * dot(g.xyz(), g.xyz());
        sum.rate += dot(g.xyz(), vertices.displacement(v, x));
      }
    }
    partial[n] = sum;
  }
};

/// The step of the multiplier of each piece.
struct Solve {
  View<const GasState> partial;
  View<const Piece> pieces;
  View<GasState> gas;
  View<float> step;
  float inverse_dt;
  bool starts;

  MENISCUS_HD void operator()(uint32_t p) const {
    const Piece& piece = pieces[p];
    step[p] = 0;
    if (piece.inside == 0) return;
    GasState sum{0, 0, 0, starts ? 0 : gas[p].multiplier};
    for (uint32_t n = p * lanes; n < (p + 1) * lanes; ++n) {
      sum.volume += partial[n].volume;
      sum.weight += partial[n].weight;
      sum.rate += partial[n].rate;
    }
    step[p] =
        xpbd_step(sum.volume - piece.inside, sum.rate, sum.weight, sum.multiplier,
                  piece.inside_compliance * inverse_dt * inverse_dt, piece.stretch_damping * inverse_dt);
    sum.multiplier += step[p];
    gas[p] = sum;
  }
};

struct Push {
  View<const Vec4> gradient;
  View<const float> step;
  VertexState vertices;

  MENISCUS_HD void operator()(uint32_t v) const {
    const float s = step[pbd::phase_group(vertices.particles.phase[vertices.particles.sorted + v])];
    if (s != 0) vertices.push(v, vertices.at(v), s * gradient[v].xyz());
  }
};

}  // namespace meniscus::cloth::volume_kernels
