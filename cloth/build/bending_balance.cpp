// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the factors of hinges vertex by vertex, by least squares with a lower bound.
#include "cloth/build/bending_balance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cloth/build/rest_geometry.h"
#include "cloth/build/tuning.h"

namespace meniscus::cloth {

namespace {

using Eigen::Vector3d;

constexpr size_t directions = 5;  // an energy of the fourth degree in n has five coefficients
/// A hinge's energy over that of the vertex, for cloth bent across each direction.
using Portion = std::array<double, directions>;

struct Frame {
  Vector3d u, v;
};

Frame frame_of(const FlatHinge& h, std::span<const Vec3> rest) {
  const Vector3d a = to_double(rest[h.a]), u = (to_double(rest[h.b]) - a).normalized();
  const Vector3d normal = u.cross(to_double(rest[h.c]) - a).normalized();
  return {u, normal.cross(u)};
}

/// Σ k w of a hinge for the bends w = x²/2, y²/2 and x y.
Vector3d bends_of(const FlatHinge& h, const Frame& frame, std::span<const Vec3> rest) {
  const Vector3d origin = to_double(rest[h.a]);
  Vector3d sum(0, 0, 0);
  for (size_t i = 0; i < 4; ++i) {
    const Vector3d from = to_double(rest[h.corners()[i]]) - origin;
    const double x = frame.u.dot(from), y = frame.v.dot(from);
    sum += h.weight[i] * Vector3d(0.5 * x * x, 0.5 * y * y, x * y);
  }
  return sum;
}

Portion portion_of(const FlatHinge& h, const Vector3d& bends, double area) {
  Portion portion{};
  for (size_t n = 0; n < directions; ++n) {
    const double turn = std::numbers::pi * static_cast<double>(n) / static_cast<double>(directions);
    const double c = std::cos(turn), s = std::sin(turn);
    const double sum = bends.dot(Vector3d(c * c, s * s, c * s));
    portion[n] = 0.5 * h.stiffness * sum * sum / area;
  }
  return portion;
}

/// Minimises Σ_n (Σ_h f_h portion − 1)² + ε Σ_h (f_h − 1)² over f ≥ least, coordinate by coordinate.
std::vector<double> fitted(const std::vector<Portion>& portions) {
  using namespace balance_tuning;
  std::vector<double> factor(portions.size(), 1);
  Portion error;
  error.fill(-1);
  for (const Portion& p : portions) {
    for (size_t n = 0; n < directions; ++n) error[n] += p[n];
  }
  double most = 1;
  for (int round = 0; round < rounds && most > accuracy; ++round) {
    most = 0;
    for (size_t h = 0; h < portions.size(); ++h) {
      double slope = preference * (factor[h] - 1), curvature = preference;
      for (size_t n = 0; n < directions; ++n) {
        slope += error[n] * portions[h][n];
        curvature += portions[h][n] * portions[h][n];
      }
      const double next = std::max(least_factor, factor[h] - slope / curvature);
      for (size_t n = 0; n < directions; ++n) error[n] += (next - factor[h]) * portions[h][n];
      most = std::max(most, std::abs(next - factor[h]));
      factor[h] = next;
    }
  }
  return factor;
}

/// Hinges by vertex.
std::vector<std::vector<uint32_t>> by_vertex(std::span<const FlatHinge> hinges, size_t vertices,
                                             size_t corners) {
  std::vector<std::vector<uint32_t>> at(vertices);
  for (uint32_t h = 0; h < hinges.size(); ++h) {
    for (size_t i = 0; i < corners; ++i) at[hinges[h].corners()[i]].push_back(h);
  }
  return at;
}

/// Whether the forces that a bend in any direction exerts on vertex v balance.
bool is_in_equilibrium(uint32_t v, std::span<const uint32_t> around, std::span<const FlatHinge> hinges,
                       const Frame& frame, std::span<const Vec3> rest) {
  Vector3d force(0, 0, 0);
  double sizes = 0;
  for (uint32_t k : around) {
    const FlatHinge& h = hinges[k];
    const Vector3d bends = bends_of(h, frame, rest);
    for (size_t i = 0; i < 4; ++i) {
      if (h.corners()[i] != v) continue;
      force += h.stiffness * h.weight[i] * bends;
      sizes += h.stiffness * std::abs(h.weight[i]) * bends.norm();
    }
  }
  return force.norm() <= balance_tuning::regular * sizes;
}

/// By vertex, whether the mesh around it is regular: bends in any direction are in equilibrium. Beside a
/// border, where hinges are missing, the mesh is as regular as at any neighbour.
std::vector<bool> regular_vertices(std::span<const FlatHinge> hinges, std::span<const Vec3> rest,
                                   std::span<const double> areas,
                                   const std::vector<std::vector<uint32_t>>& spokes) {
  const auto around = by_vertex(hinges, rest.size(), 4);
  const auto inside = [&](uint32_t v) { return !spokes[v].empty() && areas[v] > 0; };
  const auto any_neighbour = [&](uint32_t v, const auto& is) {
    return std::any_of(spokes[v].begin(), spokes[v].end(),
                       [&](uint32_t h) { return is(hinges[h].a == v ? hinges[h].b : hinges[h].a); });
  };
  std::vector<bool> in_equilibrium(rest.size(), false);
  for (uint32_t v = 0; v < rest.size(); ++v) {
    if (!inside(v) || any_neighbour(v, [&](uint32_t u) { return !inside(u); })) continue;
    in_equilibrium[v] = is_in_equilibrium(v, around[v], hinges, frame_of(hinges[spokes[v][0]], rest), rest);
  }
  std::vector<bool> regular = in_equilibrium;
  for (uint32_t v = 0; v < rest.size(); ++v) {
    if (inside(v) && any_neighbour(v, [&](uint32_t u) { return !inside(u); }))
      regular[v] = any_neighbour(v, [&](uint32_t u) { return bool{in_equilibrium[u]}; });
  }
  return regular;
}

}  // namespace

std::vector<double> balanced(std::span<const FlatHinge> hinges, std::span<const Vec3> rest,
                             std::span<const double> areas) {
  const auto spokes = by_vertex(hinges, rest.size(), 2);
  const std::vector<bool> regular = regular_vertices(hinges, rest, areas, spokes);
  std::vector<double> sum(hinges.size(), 0), ends(hinges.size(), 0);
  std::vector<Portion> portions;
  for (uint32_t v = 0; v < rest.size(); ++v) {
    if (!regular[v]) continue;
    const Frame frame = frame_of(hinges[spokes[v][0]], rest);
    portions.clear();
    for (uint32_t h : spokes[v])
      portions.push_back(portion_of(hinges[h], bends_of(hinges[h], frame, rest), areas[v]));
    const std::vector<double> factor = fitted(portions);
    for (size_t k = 0; k < factor.size(); ++k) {
      sum[spokes[v][k]] += factor[k];
      ++ends[spokes[v][k]];
    }
  }
  for (size_t h = 0; h < sum.size(); ++h) sum[h] = ends[h] > 0 ? sum[h] / ends[h] : 1;
  return sum;
}

}  // namespace meniscus::cloth
