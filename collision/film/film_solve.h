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
  View<float> residual, direction, applied, diagonal;
  View<float> part;  ///< by body: of the pressure, what particles do not exert
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
/// with linear elements. The unknown is p − ρ g·x, where x is measured from the body's centre.
struct SolveFilms {
  using Scratch = SolveScratch;

  Surfaces surfaces;
  View<const Gap> gaps;
  View<const RimPoint> rims;
  View<const uint32_t> has_film;
  View<const int64_t> pushes;  ///< by body: see AddPushes
  Vec3 gravity;
  float dt;
  SolveViews views;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t b) const {
    if (!has_film[b]) {
      group.for_each(1, [&](uint32_t) { views.part[b] = 0; });
      return;
    }
    const uint32_t first = surfaces.bodies[b].first_vertex, count = surfaces.bodies[b].vertex_end - first;
    const auto sum = [&](const auto& f) {
      return total(group, scratch, count, [&](uint32_t k) { return f(first + k); });
    };
    const auto each = [&](const auto& f) { group.for_each(count, [&](uint32_t k) { f(first + k); }); };

    const float wetness = sum([&](uint32_t v) { return rims[v].wetness; });
    const float density = sum([&](uint32_t v) { return rims[v].density; }) / pbd::max(wetness, 1e-30f);
    const Pose& pose = surfaces.proxies[b].pose;
    const Vec3 slope = density * rotate(conjugate(pose.rotation), gravity);
    const auto column = [&](uint32_t v) { return dot(slope, surfaces.vertices[v]); };

    each([&](uint32_t v) { views.pressure[v] = -column(v); });
    each([&](uint32_t v) {
      views.diagonal[v] = diagonal(v);
      views.residual[v] =
          is_solved(v) ? rims[v].exchange * (rims[v].pressure - column(v)) - apply(v, views.pressure) : 0;
      views.direction[v] = preconditioned(v);
    });
    float product = sum([&](uint32_t v) { return views.residual[v] * preconditioned(v); });
    const float enough = film_tuning::residual * film_tuning::residual * product;
    for (uint32_t step = 0; step < film_tuning::most_steps && product > enough; ++step) {
      each([&](uint32_t v) { views.applied[v] = is_solved(v) ? apply(v, views.direction) : 0; });
      const float curvature = sum([&](uint32_t v) { return views.direction[v] * views.applied[v]; });
      if (!(curvature > 0)) break;
      const float along = product / curvature;
      each([&](uint32_t v) {
        views.pressure[v] += along * views.direction[v];
        views.residual[v] -= along * views.applied[v];
      });
      const float next = sum([&](uint32_t v) { return views.residual[v] * preconditioned(v); });
      const float keep = next / product;
      each([&](uint32_t v) { views.direction[v] = preconditioned(v) + keep * views.direction[v]; });
      product = next;
    }
    each([&](uint32_t v) {
      views.pressure[v] = is_solved(v) ? pbd::max(0.0f, views.pressure[v] + column(v)) : 0;
    });

    const uint32_t begin = surfaces.bodies[b].first_triangle,
                   triangles = surfaces.bodies[b].triangle_end - begin;
    const float load = total(group, scratch, triangles, [&](uint32_t k) {
      const FilmTriangle& t = surfaces.triangles[begin + k];
      return gaps[begin + k].film * length(t.area) * mean_pressure(t, views.pressure);
    });
    const float pushed = static_cast<float>(static_cast<double>(pushes[b]) * film_tuning::unit);
    group.for_each(
        1, [&](uint32_t) { views.part[b] = load > 0 ? pbd::max(0.0f, 1 - pushed / (dt * load)) : 0; });
  }

 private:
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

  /// The sum over k below count, with the same bits each time.
  template <class Group, class F>
  MENISCUS_HD static float total(const Group& group, Scratch& scratch, uint32_t count, const F& f) {
    group.for_each(Scratch::lanes, [&](uint32_t lane) {
      float sum = 0;
      for (uint32_t k = lane; k < count; k += Scratch::lanes) sum += f(k);
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

}  // namespace meniscus::collision::film_kernels
