// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cloth/vertex_state.h"
#include "cloth/wind.h"
#include "pbd/surface.h"

namespace meniscus::cloth::wind_kernels {

/// The air's force on a triangle: as on a flat plate with the relative wind u, normal n and area A,
///
///   drag  ½ ρ A C_D |u·n| u        lift  ½ ρ A C_L (u·n) (|u| n − (u·n) u/|u|)
struct BlowOnTriangles {
  View<const pbd::SurfaceTriangle> triangles;
  VertexState vertices;
  Wind wind;
  float time;
  View<Vec4> force;  ///< N, on each corner; w: N·s/m, how fast it goes down with the speed, at most

  MENISCUS_HD void operator()(uint32_t k) const {
    const pbd::SurfaceTriangle t = triangles[k];
    const Piece& piece = vertices.pieces[t.part];
    force[k] = {0, 0, 0, 0};
    if (piece.drag == 0 && piece.lift == 0) return;
    const Vec3 a = vertices.position(t.a).xyz(), b = vertices.position(t.b).xyz(),
               c = vertices.position(t.c).xyz();
    const Vec3 speed = (1.0f / 3) * (velocity(t.a) + velocity(t.b) + velocity(t.c));
    const Vec3 u = wind.at((1.0f / 3) * (a + b + c), time) - speed;
    const Vec3 normal = cross(b - a, c - a);
    const float twice_area = length(normal), fast = length(u);
    if (twice_area < 1e-20f || fast < 1e-9f) return;
    const float through = dot(u, normal) / twice_area, scale = 0.5f / 6 * wind.density * twice_area;
    const float lift = scale * piece.lift * through;
    const Vec3 f = (scale * piece.drag * fabsf(through) - lift * through / fast) * u +
                   (lift * fast / twice_area) * normal;
    force[k] = pbd::with_w(f, scale * (2 * piece.drag + piece.lift) * fast);
  }

  MENISCUS_HD Vec3 velocity(uint32_t v) const {
    return vertices.particles.velocity[vertices.particles.sorted + v].xyz();
  }
};

/// Moves vertices by what acts on their triangles.
struct Blow {
  View<const uint32_t> fan_start, fan;
  View<const Vec4> force;
  VertexState vertices;
  float dt;

  MENISCUS_HD void operator()(uint32_t v) const {
    Vec3 sum{0, 0, 0};
    float stiffness = 0;
    for (uint32_t k = fan_start[v]; k < fan_start[v + 1]; ++k) {
      const Vec4 f = load(force, fan[k] / 3);
      sum += f.xyz();
      stiffness += f.w;
    }
    const Vertex vertex = vertices.at(v);
    // A light vertex takes the wind's speed, and no more.
    vertices.push(v, vertex, dt * dt / pbd::max(1.0f, dt * vertex.x.w * stiffness) * sum);
  }
};

}  // namespace meniscus::cloth::wind_kernels
