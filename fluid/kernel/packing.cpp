// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Relaxes packings, and sums kernels over them.
#include "fluid/kernel/packing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "fluid/kernel/tuning.h"

namespace meniscus::fluid {

namespace {

using Point = std::array<double, 3>;

double square(double a) {
  return a * a;
}
double cube(double a) {
  return a * a * a;
}

Point& operator+=(Point& a, const Point& b) {
  for (size_t k = 0; k < 3; ++k) a[k] += b[k];
  return a;
}
Point scaled(double a, const Point& b) {
  return {a * b[0], a * b[1], a * b[2]};
}
double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A neighbour of a point: its number, the unit vector away from it, and the distance.
struct Pair {
  size_t other;
  Point away;
  double r;
};
using Pairs = std::vector<std::vector<Pair>>;

/// All pairs nearer than `reach`, each by its nearest periodic image.
Pairs find_pairs(const Packing& packing, double reach) {
  Pairs pairs(packing.points.size());
  const double half = packing.side / 2;
  for (size_t i = 0; i < pairs.size(); ++i) {
    for (size_t j = i + 1; j < pairs.size(); ++j) {
      Point d = packing.points[i];
      d += scaled(-1, packing.points[j]);
      for (double& x : d) x -= x > half ? packing.side : x < -half ? -packing.side : 0;
      const double r2 = dot(d, d);
      if (r2 >= reach * reach) continue;
      const double r = std::sqrt(std::max(r2, 1e-20));
      pairs[i].push_back({j, scaled(1 / r, d), r});
      pairs[j].push_back({i, scaled(-1 / r, d), r});
    }
  }
  return pairs;
}

/// e of all pairs, in the order of the pairs.
std::vector<std::vector<Point>> slopes_of(const Pairs& pairs, const ExactKernel& kernel) {
  std::vector<std::vector<Point>> slopes(pairs.size());
  for (size_t i = 0; i < pairs.size(); ++i) {
    for (const Pair& p : pairs[i]) slopes[i].push_back(scaled(kernel.slope(p.r), p.away));
  }
  return slopes;
}

}  // namespace

double ExactKernel::weight(double r) const {
  const double q = r / h, u = std::max(0.0, 1 - q), per_volume = 1 / (std::numbers::pi * cube(h));
  switch (shape) {
    case SmoothingKernel::wendland_c2:
      return 10.5 * per_volume * square(square(u)) * (1 + 4 * q);
    case SmoothingKernel::cubic_spline:
      return 8 * per_volume * (2 * cube(u) - 8 * cube(std::max(0.0, 0.5 - q)));
    case SmoothingKernel::poly6_spiky:
      break;
  }
  return 315.0 / 64 * per_volume * cube(std::max(0.0, 1 - q * q));
}

double ExactKernel::slope(double r) const {
  const double q = r / h, u = std::max(0.0, 1 - q), scale = 1 / (std::numbers::pi * square(h * h));
  switch (shape) {
    case SmoothingKernel::wendland_c2:
      return 210 * scale * q * cube(u);
    case SmoothingKernel::cubic_spline:
      return 48 * scale * (u * u - 4 * square(std::max(0.0, 0.5 - q)));
    case SmoothingKernel::poly6_spiky:
      break;
  }
  return 45 * scale * u * u;
}

/// A cube is large enough if no point has two images of another in reach.
Packing cubic_lattice(double support_radius) {
  const int n = std::max(kernel_tuning::least_packing, static_cast<int>(std::ceil(2 * support_radius)));
  Packing packing{double(n), {}};
  for (int i = 0; i < n * n * n; ++i)
    packing.points.push_back({i % n + 0.5, i / n % n + 0.5, i / (n * n) + 0.5});
  return packing;
}

Packing relaxed_packing(const ExactKernel& kernel) {
  Packing packing = cubic_lattice(kernel.h);
  std::mt19937 random(1);
  for (Point& p : packing.points) {
    for (double& x : p) x = packing.side * (static_cast<double>(random()) * 0x1p-32);
  }
  for (int round = 0; round < kernel_tuning::packing_rounds; ++round) {
    const Pairs pairs = find_pairs(packing, kernel.h);
    const double step = kernel_tuning::packing_step * square(kernel.h);
    for (size_t i = 0; i < pairs.size(); ++i) {
      Point move{};
      for (const Pair& p : pairs[i]) move += scaled(step * kernel.slope(p.r), p.away);
      const double bound = kernel_tuning::packing_limit / std::sqrt(std::max(dot(move, move), 1e-20));
      packing.points[i] += scaled(std::min(1.0, bound), move);
      for (double& x : packing.points[i]) x -= packing.side * std::floor(x / packing.side);
    }
  }
  return packing;
}

PackingSums sum_over(const Packing& packing, const ExactKernel& kernel) {
  const auto count = static_cast<double>(packing.points.size());
  PackingSums sums{kernel.weight(0), 0, 0};
  for (const auto& neighbours : find_pairs(packing, kernel.h)) {
    for (const Pair& p : neighbours) {
      sums.weight += kernel.weight(p.r) / count;
      sums.gradient += kernel.slope(p.r) * p.r / 3 / count;
      sums.gradient2 += square(kernel.slope(p.r)) / count;
    }
  }
  return sums;
}

/// By power iteration. A = ∇C ∇Cᵀ, and D has A's diagonal.
double spectral_radius(const Packing& packing, const ExactKernel& kernel) {
  const Pairs pairs = find_pairs(packing, kernel.h);
  const auto slopes = slopes_of(pairs, kernel);
  const size_t count = pairs.size();
  std::vector<double> v(count), diagonal(count);
  std::vector<Point> moves(count);
  std::mt19937 random(1);
  for (size_t i = 0; i < count; ++i) {
    Point sum{};
    for (const Point& e : slopes[i]) {
      sum += e;
      diagonal[i] += dot(e, e);
    }
    diagonal[i] += dot(sum, sum);
    v[i] = static_cast<double>(random()) * 0x1p-32 - 0.5;
  }
  double radius = 0;
  for (int round = 0; round < kernel_tuning::spectral_rounds; ++round) {
    double before = 0, after = 0;
    for (size_t i = 0; i < count; ++i) {
      moves[i] = {};
      for (size_t k = 0; k < pairs[i].size(); ++k)
        moves[i] += scaled(v[i] + v[pairs[i][k].other], slopes[i][k]);
      before += v[i] * v[i];
    }
    for (size_t i = 0; i < count; ++i) {
      double change = 0;
      for (size_t k = 0; k < pairs[i].size(); ++k)
        change += dot(slopes[i][k], moves[i]) - dot(slopes[i][k], moves[pairs[i][k].other]);
      v[i] = change / diagonal[i];
      after += v[i] * v[i];
    }
    radius = std::sqrt(after / before);
    for (double& x : v) x /= std::sqrt(after);
  }
  return radius;
}

}  // namespace meniscus::fluid
