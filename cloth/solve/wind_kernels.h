// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of the air's force on cloth.
#pragma once

#include "cloth/build/wind.h"
#include "cloth/solve/load_kernels.h"
#include "cloth/solve/vertex_state.h"
#include "pbd/device/side_by_side.h"
#include "pbd/surface_tree/surface.h"

namespace meniscus::cloth::wind_kernels {

using pbd::gather;
using pbd::max;
using pbd::scatter;
using pbd::square_root;

/// The force of the air on a triangle, as on a flat plate with relative wind u, normal n and area A:
///
///   drag  ½ ρ A C_D |u·n| u        lift  ½ ρ A C_L (u·n) (|u| n − (u·n) u/|u|)
struct BlowOnTriangles {
  View<const pbd::SurfaceTriangle> triangles;
  VertexState vertices;
  Wind wind;
  float time;                                   ///< s
  View<const load_kernels::WorldClock> clocks;  ///< in place of `time`, by world of a batch
  View<Vec4>
      force;  ///< N, on each corner; w: N·s/m, the greatest rate at which the force falls with the speed

  template <class D>
  MENISCUS_HD void run(const pbd::SideBySide<D>& together) const {
    using Real = typename D::Real;
    using Vector = pbd::Vec3Of<Real>;
    const Real zero(0), third(1.0f / 3);
    pbd::Places<D> corner[3];
    for (uint32_t lane = 0; lane < D::lane_count; ++lane) {
      const pbd::SurfaceTriangle& t = triangles[together.items.at[lane]];
      corner[0].at[lane] = t.a;
      corner[1].at[lane] = t.b;
      corner[2].at[lane] = t.c;
    }
    const auto of_all = [&](View<Vec4> values, uint32_t k) {
      return gather(values.from(vertices.particles.sorted), corner[k].index()).xyz();
    };
    const auto of_piece = [&](float Piece::*value) {
      if (vertices.pieces.count == 1) return Real(vertices.pieces[0].*value);
      return pbd::by_lane<D>(
          [&](uint32_t lane) { return vertices.pieces[triangles[together.items.at[lane]].piece].*value; });
    };
    const View<Vec4> position = vertices.particles.position, velocity = vertices.particles.velocity;
    const Vector a = of_all(position, 0), b = of_all(position, 1), c = of_all(position, 2);
    const Vector speed = third * (of_all(velocity, 0) + of_all(velocity, 1) + of_all(velocity, 2));
    const auto time_of = [&](uint32_t lane) {
      const uint32_t each = triangles.count / clocks.count;
      return static_cast<float>(clocks[together.items.at[lane] / each].time);
    };
    const Real now = clocks.count ? pbd::by_lane<D>(time_of) : Real(time);
    const Vector u = wind.at(third * (a + b + c), now) - speed;
    const Vector normal = cross(b - a, c - a);
    const Real twice_area = square_root(dot(normal, normal)), fast = square_root(dot(u, u));
    // A triangle without area, or one that moves with the air, feels no force.
    const auto if_felt = [&](const Real& x) {
      return select_less(twice_area, Real(1e-20f), zero, select_less(fast, Real(1e-9f), zero, x));
    };
    const Real drag = of_piece(&Piece::drag), lift = of_piece(&Piece::lift);
    const Real through = dot(u, normal) / twice_area, scale = Real(0.5f / 6 * wind.density) * twice_area;
    const Real lifted = scale * lift * through;
    const Vector f = (scale * drag * max(through, -through) - lifted * through / fast) * u +
                     (lifted * fast / twice_area) * normal;
    scatter(force, together.index(),
            {if_felt(f.x), if_felt(f.y), if_felt(f.z), if_felt(scale * (Real(2) * drag + lift) * fast)},
            together.mask());
  }
};

/// Moves vertices by the forces on their triangles.
struct Blow {
  View<const uint32_t> corner_start, corners;
  View<const Vec4> force;
  VertexState vertices;
  float dt;
  float fraction;  // of the force, for one iteration

  MENISCUS_HD void operator()(uint32_t v) const {
    Vec4 sum{0, 0, 0, 0};
    for (uint32_t k = corner_start[v]; k < corner_start[v + 1]; ++k)
      sum = plus(sum, 1, load(force, corners[k] / 3));
    const Vertex vertex = vertices.at(v);
    // A light vertex reaches the speed of the wind, and no more.
    const float stiffness = sum.w;
    vertices.push(v, vertex, fraction * dt * dt / pbd::max(1.0f, dt * vertex.x.w * stiffness) * sum.xyz());
  }
};

}  // namespace meniscus::cloth::wind_kernels
