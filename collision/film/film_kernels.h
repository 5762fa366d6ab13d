// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of films: where they are, and the pressure at their rims. The equation for the pressure between
// is in film_solve.h, and the loads are in film_loads.h.
#pragma once

#include "collision/body/proxy.h"
#include "collision/contact/candidates.h"
#include "collision/contact/opening.h"
#include "collision/film/film_surface.h"
#include "collision/film/tuning.h"
#include "pbd/grid.h"
#include "pbd/math/tangents.h"
#include "pbd/particles.h"

namespace meniscus::collision::film_kernels {

using pbd::View;

/// The state of a triangle.
struct Gap {
  float film;         ///< the fraction of it that a film covers
  float exposure;     ///< the fraction that is open to fluid or air
  float conductance;  ///< g³, of the widest gap's
  uint32_t shape;     ///< the other face's, where there is a film
  Vec3 normal;        ///< of the other face
  float distance;     ///< m, of the other face
  float wet;          ///< the fraction that is exposed to fluid
};

/// The state of a vertex.
struct RimPoint {
  float exchange;  ///< the conductance to what is beside it; negative: no film is near
  float pressure;  ///< Pa, of what is beside it
  float density;   ///< kg/m³, of the fluid beside it, times
  float wetness;   ///< how wet it is there, 0 to 1
};

/// The lengths of a film, m.
struct Lengths {
  float spacing, contact_radius, support_radius;

  MENISCUS_HD float widest() const { return film_tuning::wide * contact_radius; }
  /// The fraction of a face at this distance (m) from another that has a film. `facing`: the cosine between
  /// one's normal and the opposite of the other's.
  MENISCUS_HD float film_between(float gap, float facing) const {
    using namespace film_tuning;
    const float width = (gap / contact_radius - narrow) / (wide - narrow);
    return (1 - pbd::clamp(width, 0.0f, 1.0f)) *
           pbd::clamp((facing - least_facing) / (whole_facing - least_facing), 0.0f, 1.0f);
  }
  MENISCUS_HD float conductance(float gap) const {
    const float g = pbd::max(gap, film_tuning::roughness * contact_radius) / widest();
    return g * g * g;
  }
};

/// By world of a batch, or one for all; m/s².
struct WorldGravity {
  Vec3 common;
  uint32_t bodies = 0;  ///< of a world, where there are several
  View<const pbd::Vec4> by_world{};

  MENISCUS_HD uint32_t world_of(uint32_t body) const { return bodies ? body / bodies : 0; }
  MENISCUS_HD Vec3 of(uint32_t body) const {
    return by_world.count ? by_world[world_of(body)].xyz() : common;
  }
};

/// The fluid particles.
struct Fluid {
  pbd::GridView grid;
  View<const pbd::Vec4> position;
  View<const pbd::Phase> phase;
  View<const CollisionFilter> filters;  ///< by fluid, or none
  const float* multiplier;              ///< of the first particle
  uint32_t stride;                      ///< floats from one particle's multiplier to that of the next
  float to_pressure;
  WorldGravity gravity;

  /// Whether this rank has all particles near p.
  MENISCUS_HD bool is_own(Vec3 p) const { return grid.owns(grid.coordinates(p)); }
  MENISCUS_HD float pressure(uint32_t i) const { return to_pressure * multiplier[size_t{stride} * i]; }
  /// Calls visit(particle, its position) for each particle near p that the solid of a body collides with.
  template <class Visit>
  MENISCUS_HD void for_each_near(Vec3 p, const Shape& solid, const Visit& visit) const {
    const uint32_t first_cell = gravity.world_of(solid.body) << grid.key_bits();
    pbd::RunsAround(grid, p, first_cell).for_each([&](uint32_t begin, uint32_t end) {
      for (uint32_t i = begin; i < end; ++i) {
        if (pbd::is_grain(phase[i])) continue;
        if (filters.count && !collide(solid, filters[pbd::phase_group(phase[i])])) continue;
        visit(i, position[i]);
      }
    });
  }
};

/// Directions against gravity and across it.
struct LevelAxes {
  Vec3 up, first, second;

  MENISCUS_HD explicit LevelAxes(Vec3 gravity) {
    up = normalized_or(-gravity, {0, 1, 0});
    const Tangents across(up);
    first = across.u;
    second = across.v;
  }
};

/// By world of a batch, or one for all.
struct WorldAxes {
  LevelAxes common;
  uint32_t bodies = 0;  ///< of a world
  View<const LevelAxes> by_world{};

  MENISCUS_HD const LevelAxes& of(uint32_t body) const {
    return by_world.count ? by_world[body / bodies] : common;
  }
};

/// All surfaces as kernels read them.
struct Surfaces {
  View<const Vec3> vertices;
  View<const FilmTriangle> triangles;
  View<const uint32_t> first_corner;
  View<const FilmCorner> corners;
  View<const FilmRange> bodies;
  View<const BodyProxy> proxies;
};

/// Writes the centres of triangles in world axes.
struct PlaceCentres {
  Surfaces surfaces;
  View<pbd::Vec4> centre;

  MENISCUS_HD void operator()(uint32_t n) const {
    const FilmTriangle& t = surfaces.triangles[n];
    centre[n] = pbd::with_w(to_world(surfaces.proxies[t.body].pose, t.centre), 0);
  }
};

/// Finds the gap under each triangle.
struct FindGaps {
  Surfaces surfaces;
  ShapeSet set;
  CandidateView candidates;
  View<const pbd::Vec4> centre;
  Lengths lengths;
  WorldAxes axes;
  View<Gap> gaps;

  MENISCUS_HD void operator()(uint32_t n) const {
    const FilmTriangle& t = surfaces.triangles[n];
    const Vec3 x = centre[n].xyz();
    const Vec3 normal = rotate(surfaces.proxies[t.body].pose.rotation, normalized_or(t.area, {0, 1, 0}));
    Gap gap{0, 1, 0, pbd::no_index, {0, 0, 0}, lengths.widest(), 0};
    bool sealed = false;
    candidates.for_each_near(set, n, {x, x}, lengths.widest(), [&](uint32_t k) {
      if (k == t.shape) return;
      const Shape& other = set.shapes[k];
      if (ignores(other, x)) return;
      const SurfaceSample s = sample_surface(set, other, x, lengths.widest());
      if (s.distance < -lengths.contact_radius) sealed = true;
      if (other.body == t.body || !(s.distance < gap.distance)) return;
      if (-dot(s.normal, normal) <= film_tuning::least_facing) return;
      gap.shape = k;
      gap.normal = s.normal;
      gap.distance = s.distance;
    });
    if (gap.shape != pbd::no_index && !has_film(t.body, set.shapes[gap.shape].body, normal, gap.normal))
      sealed = true;
    if (sealed) {
      gap.exposure = 0;
    } else if (gap.shape != pbd::no_index) {
      gap.film = lengths.film_between(gap.distance, -dot(gap.normal, normal));
      gap.exposure = 1 - gap.film;
      gap.conductance = lengths.conductance(gap.distance);
    }
    gaps[n] = gap;
  }

  /// Of two bodies with surfaces one has the film: the upper one, or if neither is, the one of lower rank.
  MENISCUS_HD bool has_film(uint32_t body, uint32_t other, Vec3 normal, Vec3 others_normal) const {
    if (other == pbd::no_index) return true;
    const FilmRange& range = surfaces.bodies[other];
    if (range.first_triangle == range.triangle_end) return true;
    const float lower = dot(others_normal - normal, axes.of(body).up);
    if (fabsf(lower) > film_tuning::upright) return lower > 0;
    return surfaces.bodies[body].rank < range.rank;
  }
  /// Whether x is at an opening of a container's wall, or has left the container by one.
  MENISCUS_HD bool ignores(const Shape& plane, Vec3 x) const {
    if (plane.kind != ShapeKind::plane || plane.wall_count == 0) return false;
    for (uint32_t k = plane.first_wall; k < plane.first_wall + plane.wall_count; ++k)
      if (plane_surface(set.shapes[k], x).distance < -lengths.contact_radius) return true;
    return in_opening(set, plane, x);
  }
};

/// How much of the kernel around x the fluid fills on the side of `outwards`, as a factor of each particle:
/// 15/(8π) (1 − r²/h²) s³/h³. Epanechnikov's kernel gives means of the least variance.
struct Window {
  float inverse_h2, scale;

  MENISCUS_HD explicit Window(const Lengths& lengths) {
    const float s = lengths.spacing / lengths.support_radius;
    inverse_h2 = 1 / (lengths.support_radius * lengths.support_radius);
    scale = 0.59683104f * s * s * s;
  }
  MENISCUS_HD float operator()(Vec3 d, Vec3 outwards) const {
    return dot(d, outwards) > 0 ? scale * pbd::max(0.0f, 1 - inverse_h2 * dot(d, d)) : 0.0f;
  }
};

/// Finds how much of each exposed triangle is wet, for bodies with films. A gap in which particles do not fit
/// well counts as wet. Where ranks share the fluid, each looks at what is in its own region.
struct FindWetFaces {
  Surfaces surfaces;
  ShapeSet set;
  View<const pbd::Vec4> centre;
  View<const uint32_t> has_film;
  Fluid fluid;
  Lengths lengths;
  View<Gap> gaps;

  MENISCUS_HD void operator()(uint32_t n) const {
    const FilmTriangle& t = surfaces.triangles[n];
    Gap& gap = gaps[n];
    if (!has_film[t.body] || !(gap.exposure > 0)) return;
    if (gap.shape != pbd::no_index) {
      gap.wet = gap.exposure;
      return;
    }
    const Vec3 x = centre[n].xyz(), normal = rotate(surfaces.proxies[t.body].pose.rotation, t.area);
    if (!fluid.is_own(x)) return;
    const Window window(lengths);
    float weight = 0;
    fluid.for_each_near(x, set.shapes[t.shape],
                        [&](uint32_t, const pbd::Vec4& p) { weight += window(p.xyz() - x, normal); });
    gap.wet = gap.exposure * pbd::min(weight / film_tuning::wet, 1.0f);
  }
};

/// Finds the pressure beside each vertex of a film that is open there, if that is in the region of the rank.
/// `has_film`: by body, whether a film of it is wet.
struct FindRims {
  Surfaces surfaces;
  ShapeSet set;
  View<const Gap> gaps;
  Fluid fluid;
  Lengths lengths;
  View<RimPoint> rims;
  View<uint32_t> has_film;

  MENISCUS_HD void operator()(uint32_t v) const {
    float film = 0, whole = 0, open = 0, conductance = 0;
    Vec3 outwards{0, 0, 0}, facing{0, 0, 0};
    uint32_t other = pbd::no_index;
    for (uint32_t k = surfaces.first_corner[v]; k < surfaces.first_corner[v + 1]; ++k) {
      const FilmTriangle& t = surfaces.triangles[surfaces.corners[k].triangle];
      const Gap& gap = gaps[surfaces.corners[k].triangle];
      const float area = length(t.area);
      whole += area;
      film += gap.film * area;
      open += gap.exposure * area;
      outwards = outwards + gap.exposure * t.area;
      conductance += gap.film * area * gap.conductance;
      facing = facing + gap.film * area * gap.normal;
      if (gap.film > 0) other = gap.shape;
    }
    rims[v] = {-1, 0, 0, 0};
    if (!(film > 0)) return;
    rims[v].exchange = film_tuning::rim * (open / whole) * (conductance / film);
    if (!(open > 0)) return;
    const FilmTriangle& any = surfaces.triangles[surfaces.corners[surfaces.first_corner[v]].triangle];
    const Pose& pose = surfaces.proxies[any.body].pose;
    look(v, to_world(pose, surfaces.vertices[v]), rotate(pose.rotation, outwards),
         normalized_or(facing, {0, 0, 0}), set.shapes[any.shape], set.shapes[other]);
    if (rims[v].pressure > 0) pbd::atomic_max(has_film[any.body], 1);
  }

  /// What is outwards from x, and on this side of the other face. Fluid with air beside it has less support
  /// than `wet`. The pressure fades with that.
  MENISCUS_HD void look(uint32_t v, Vec3 x, Vec3 outwards, Vec3 facing, const Shape& solid,
                        const Shape& other) const {
    if (!fluid.is_own(x)) return;
    const Window window(lengths);
    const Vec3 gravity = fluid.gravity.of(solid.body);
    float weight = 0, pressure = 0, density = 0;
    fluid.for_each_near(x, solid, [&](uint32_t i, const pbd::Vec4& p) {
      const Vec3 d = p.xyz() - x;
      const float w = window(d, outwards);
      if (!(w > 0) || p.w <= 0) return;
      const SurfaceSample behind = sample_surface(set, other, p.xyz(), 2 * lengths.support_radius);
      if (behind.distance < 0 || dot(behind.normal, facing) < -film_tuning::whole_facing) return;
      const float rho = 1 / (p.w * lengths.spacing * lengths.spacing * lengths.spacing);
      weight += w;
      density += w * rho;
      pressure += w * (fluid.pressure(i) - rho * dot(gravity, d));
    });
    if (!(weight > 0)) return;
    const float wetness = pbd::min(weight / film_tuning::wet, 1.0f);
    rims[v].pressure = pbd::max(0.0f, wetness * pressure / weight);
    rims[v].density = wetness * density / weight;
    rims[v].wetness = wetness;
  }
};

}  // namespace meniscus::collision::film_kernels
