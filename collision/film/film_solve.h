// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Solves for the pressure of films.
#pragma once

#include "collision/film/film_loads.h"

namespace meniscus::collision::film_kernels {

/// What is solved with, by vertex.
struct SolveViews {
  View<float> pressure;  ///< in the end p, Pa
  View<float> wet_part;  ///< how much of p is that of wet rims, 0 to 1
  View<float> residual, direction, applied, diagonal;
};

/// Scratch memory: sums in lanes of fixed stride.
struct SolveScratch {
  static constexpr uint32_t lanes = 64;
  float part[lanes], sum;
};

/// Conjugate gradients with the diagonal as preconditioner, for one body at a time:
///
///   Σ_T film g³ ∫ ∇(p − ρ g·x)·∇u + exchange (p − rim pressure) u = 0
///
/// with linear elements. The unknown is p − ρ g·x, where x is measured from the body's centre. The same with
/// wetness for pressure gives how much of p comes from wet rims. With that the pressure of the fluid around
/// the body follows, and what it should exert on the exposed faces.
struct SolveFilms {
  using Scratch = SolveScratch;

  Surfaces surfaces;
  View<const Gap> gaps;
  View<const RimPoint> rims;
  View<const uint32_t> has_film;
  View<const ParticleLoad> particles;
  Lengths lengths;
  WorldGravity world_gravity;
  float dt;
  SolveViews views;
  View<Balance> balance;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t b) const {
    const FilmRange& range = surfaces.bodies[b];
    const Vec3 gravity = world_gravity.of(b);
    const Vertices<Group> vertices{group, scratch, range.first_vertex, range.vertex_end};
    if (!has_film[b]) {
      vertices.each([&](uint32_t v) { views.pressure[v] = 0; });
      group.for_each(1, [&](uint32_t) { balance[b] = {}; });
      return;
    }
    const float wetness = vertices.sum([&](uint32_t v) { return rims[v].wetness; });
    const float density = vertices.sum([&](uint32_t v) { return rims[v].density; }) / some(wetness);
    const Quat to_body = conjugate(surfaces.proxies[b].pose.rotation);
    const Vec3 slope = density * rotate(to_body, gravity);
    const auto column = [&](Vec3 x) { return dot(slope, x); };
    const auto column_at = [&](uint32_t v) { return column(surfaces.vertices[v]); };

    vertices.each([&](uint32_t v) {
      views.diagonal[v] = diagonal(v);
      views.pressure[v] = -column_at(v);
      views.wet_part[v] = rims[v].wetness;
    });
    solve(vertices, views.wet_part, [&](uint32_t v) { return rims[v].wetness; });
    solve(vertices, views.pressure, [&](uint32_t v) { return rims[v].pressure - column_at(v); });
    vertices.each([&](uint32_t v) {
      views.pressure[v] = is_solved(v) ? pbd::max(0.0f, views.pressure[v] + column_at(v)) : 0;
    });

    // Dry rims have no pressure at this height.
    const auto dry = [&](uint32_t v) { return rims[v].exchange > 0 ? 1 - rims[v].wetness : 0.0f; };
    const float height = vertices.sum([&](uint32_t v) { return dry(v) * column_at(v); }) /
                         some(vertices.sum([&](uint32_t v) { return dry(v); }));
    const Vertices<Group> triangles{group, scratch, range.first_triangle, range.triangle_end};
    const LevelAxes axes(gravity);
    const Vec3 up = rotate(to_body, axes.up), first = rotate(to_body, axes.first),
               second = rotate(to_body, axes.second);
    const auto triangle = [&](uint32_t n) -> const FilmTriangle& { return surfaces.triangles[n]; };
    const auto pressure = [&](uint32_t n) { return mean_pressure(triangle(n), views.pressure); };
    const auto moments = [&](const auto& force) {
      return UpwardForce{
          triangles.sum(force),
          triangles.sum([&](uint32_t n) { return force(n) * dot(triangle(n).centre, first); }),
          triangles.sum([&](uint32_t n) { return force(n) * dot(triangle(n).centre, second); })};
    };

    const auto foot = [&](uint32_t n) { return gaps[n].film * fabsf(dot(triangle(n).area, up)); };
    const float around =
        triangles.sum(
            [&](uint32_t n) { return foot(n) * (pressure(n) - (column(triangle(n).centre) - height)); }) /
        some(triangles.sum([&](uint32_t n) { return foot(n) * mean_pressure(triangle(n), views.wet_part); }));
    const UpwardForce exposed = moments([&](uint32_t n) {
      const float p = around + column(triangle(n).centre) - height;
      return -gaps[n].wet * dot(triangle(n).area, up) * pbd::max(0.0f, p);
    });
    const auto film = [&](uint32_t n) { return -gaps[n].film * dot(triangle(n).area, up) * pressure(n); };
    const UpwardForce load = moments(film);
    const float per_load = fabsf(load.sum) > 0 ? 1 / load.sum : 0, u = per_load * load.first,
                v = per_load * load.second;
    const auto spread = [&](Vec3 axis, float middle, Vec3 other, float others_middle) {
      return per_load * triangles.sum([&](uint32_t n) {
        return film(n) * (dot(triangle(n).centre, axis) - middle) *
               (dot(triangle(n).centre, other) - others_middle);
      });
    };
    // Feet that are narrower than a particle bear no torque.
    const float least = lengths.contact_radius * lengths.contact_radius;
    const float uu = least + pbd::max(0.0f, spread(first, u, first, u)),
                vv = least + pbd::max(0.0f, spread(second, v, second, v)), uv = spread(first, u, second, v);
    const float level = triangles.sum([&](uint32_t n) {
      const float area = length(triangle(n).area), upright = dot(triangle(n).area, up) / some(area);
      return gaps[n].film * area * (1 - upright * upright) * pressure(n);
    });
    group.for_each(1, [&](uint32_t) {
      const UpwardForce exerted = per_time(particles[b].up, dt);
      const float across = static_cast<float>(static_cast<double>(particles[b].across) * film_tuning::unit);
      balance[b] = {
          {exposed.sum - exerted.sum, exposed.first - exerted.first, exposed.second - exerted.second},
          load.sum,
          {u, v},
          {uu, vv, uv},
          pbd::max(0.0f, 1 - across / (dt * some(level))),
          0,
          {0, 0}};
    });
  }

 private:
  /// A range of vertices or triangles, and sums over it with the same bits each time.
  template <class Group>
  struct Vertices {
    const Group& group;
    Scratch& scratch;
    uint32_t first, end;

    template <class F>
    MENISCUS_HD void each(const F& f) const {
      group.for_each(end - first, [&](uint32_t k) { f(first + k); });
    }
    template <class F>
    MENISCUS_HD float sum(const F& f) const {
      group.for_each(Scratch::lanes, [&](uint32_t lane) {
        float sum = 0;
        for (uint32_t k = first + lane; k < end; k += Scratch::lanes) sum += f(k);
        scratch.part[lane] = sum;
      });
      group.for_each(1, [&](uint32_t) {
        float sum = 0;
        for (uint32_t lane = 0; lane < Scratch::lanes; ++lane) sum += scratch.part[lane];
        scratch.sum = sum;
      });
      return scratch.sum;
    }
  };

  MENISCUS_HD static float some(float x) { return pbd::max(x, 1e-30f); }

  /// Solves for x, which holds a guess, with rim(v) beside the rims.
  template <class V, class Rim>
  MENISCUS_HD void solve(const V& vertices, View<float> x, const Rim& rim) const {
    vertices.each([&](uint32_t v) {
      views.residual[v] = is_solved(v) ? rims[v].exchange * rim(v) - apply(v, x) : 0;
      views.direction[v] = preconditioned(v);
    });
    const auto squared = [&](uint32_t v) { return views.residual[v] * preconditioned(v); };
    float product = vertices.sum(squared);
    const float enough = film_tuning::residual * film_tuning::residual * product;
    for (uint32_t step = 0; step < film_tuning::most_steps && product > enough; ++step) {
      vertices.each([&](uint32_t v) { views.applied[v] = is_solved(v) ? apply(v, views.direction) : 0; });
      const float curvature = vertices.sum([&](uint32_t v) { return views.direction[v] * views.applied[v]; });
      if (!(curvature > 0)) break;
      const float along = product / curvature;
      vertices.each([&](uint32_t v) {
        x[v] += along * views.direction[v];
        views.residual[v] -= along * views.applied[v];
      });
      const float next = vertices.sum(squared), keep = next / product;
      vertices.each([&](uint32_t v) { views.direction[v] = preconditioned(v) + keep * views.direction[v]; });
      product = next;
    }
  }

  MENISCUS_HD bool is_solved(uint32_t v) const { return rims[v].exchange >= 0 && views.diagonal[v] > 0; }
  MENISCUS_HD float preconditioned(uint32_t v) const {
    return is_solved(v) ? views.residual[v] / views.diagonal[v] : 0;
  }
  MENISCUS_HD float diagonal(uint32_t v) const {
    float sum = pbd::max(0.0f, rims[v].exchange);
    for (uint32_t k = surfaces.first_corner[v]; k < surfaces.first_corner[v + 1]; ++k) {
      const FilmCorner& c = surfaces.corners[k];
      sum += flow(c) * (c.coupling[0] + c.coupling[1]);
    }
    return sum;
  }
  MENISCUS_HD float apply(uint32_t v, View<const float> x) const {
    const float own = x[v];
    float sum = rims[v].exchange * own;
    for (uint32_t k = surfaces.first_corner[v]; k < surfaces.first_corner[v + 1]; ++k) {
      const FilmCorner& c = surfaces.corners[k];
      const float both = c.coupling[0] * (own - x[c.other[0]]) + c.coupling[1] * (own - x[c.other[1]]);
      sum += flow(c) * both;
    }
    return sum;
  }
  MENISCUS_HD float flow(const FilmCorner& c) const {
    return gaps[c.triangle].film * gaps[c.triangle].conductance;
  }
};

}  // namespace meniscus::collision::film_kernels
