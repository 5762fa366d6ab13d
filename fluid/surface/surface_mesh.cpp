// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Calibrates the scalar field of which the surface is a level set.
#include "fluid/surface/surface_mesh.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "fluid/surface/anisotropy_kernels.h"

namespace meniscus::fluid {
namespace {

/// The cubic lattice with spacing 1 below a plane through the origin, up to `radius` from it. If the plane's
/// indices add up to an odd number, the origin is midway between two layers, where the cells of the points
/// end on average.
std::vector<Vec3> half_lattice(Vec3 normal, float radius) {
  const int n = static_cast<int>(radius) + 1;
  std::vector<Vec3> points;
  for (int z = -n; z < n; ++z) {
    for (int y = -n; y < n; ++y) {
      for (int x = -n; x < n; ++x) {
        const Vec3 p = Vec3{0.5f, 0.5f, 0.5f} + Vec3{float(x), float(y), float(z)};
        if (dot(p, normal) < 0 && length(p) < radius) points.push_back(p);
      }
    }
  }
  return points;
}

std::vector<Ellipsoid> ellipsoids_of(const std::vector<Vec3>& points, const AnisotropyParameters& p) {
  std::vector<Ellipsoid> ellipsoids;
  for (const Vec3 at : points) {
    anisotropy_kernels::Moments<float> sums{1 / p.support};
    for (const Vec3 other : points) {
      const Vec3 d = other - at;
      if (dot(d, d) > 0 && dot(d, d) < p.support * p.support) sums.add(pbd::Vec3Of<float>{d.x, d.y, d.z});
    }
    ellipsoids.push_back(ellipsoid_of(p, at, sums));
  }
  return ellipsoids;
}

/// The mean of Σ (1 − u²)³ on the plane, over an area around the origin.
double mean_sum(Vec3 normal, const std::vector<Ellipsoid>& ellipsoids, float reach) {
  const Vec3 along = normalized_or(cross(normal, {0.3f, 0.5f, -0.8f}), {0, 0, 1}),
             across = cross(normal, along);
  constexpr int points = 9;
  double sum = 0;
  for (int i = 0; i < points * points; ++i) {
    const float u = 0.25f * static_cast<float>(i % points - points / 2);
    const float v = 0.25f * static_cast<float>(i / points - points / 2);
    for (const Ellipsoid& e : ellipsoids) {
      const Vec3 d = rotate(conjugate(e.rotation), u * along + v * across - e.centre) / reach;
      const Vec3 q{d.x / e.radii.x, d.y / e.radii.y, d.z / e.radii.z};
      sum += std::pow(std::max(0.0, 1 - double{dot(q, q)}), 3);
    }
  }
  return sum / (points * points);
}

}  // namespace

SurfaceField calibrate_surface(double spacing, double support_radius) {
  SurfaceField f;
  const AnisotropyParameters p = calibrate_anisotropy(1, support_radius / spacing);
  const double reach = double{f.reach};
  // Inside a fluid, Σ (1 − u²)³ is its integral.
  const double weight = 315 / (64 * std::numbers::pi) / std::pow(reach * double{p.radius}, 3);
  double iso = 0;
  const Vec3 directions[] = {{0, 1, 0}, {1, 1, 1}, {1, 2, 2}, {1, 3, 1}};
  for (const Vec3 direction : directions) {
    const Vec3 normal = normalized_or(direction, {0, 1, 0});
    const float radius = 1.5f + f.reach * 1.5f * p.radius + p.support;
    iso += weight * mean_sum(normal, ellipsoids_of(half_lattice(normal, radius), p), f.reach) /
           static_cast<double>(std::size(directions));
  }
  // A single drop ends at u = 1/reach.
  const double lone_weight = iso / std::pow(1 - 1 / (reach * reach), 3);
  f.weight = static_cast<float>(weight);
  f.power =
      static_cast<float>(std::log(lone_weight / weight) / (3 * std::log(double{p.radius / p.lone_radius})));
  f.unit_volume = static_cast<float>(std::pow(double{p.radius} * spacing, 3));
  f.iso = static_cast<float>(iso);
  return f;
}

}  // namespace meniscus::fluid
