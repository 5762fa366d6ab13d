// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// One damped Jacobi iteration of the density constraint, directly from its formulas: in double, over all
// pairs, and with the mirror ghost of every particle in every wall.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fluid/kernel/packing.h"
#include "tests/bench/harness/solver_bench.h"

namespace meniscus::tests {

using Double3 = std::array<double, 3>;

struct ReferencePlane {
  Double3 normal;
  double offset;
};

class DensityReference {
 public:
  explicit DensityReference(const DensityCase& setup) : multipliers(setup.particles.size()), setup_(setup) {
    for (const pbd::Vec4& p : setup.particles) {
      positions.push_back({p.x, p.y, p.z});
      inverse_masses_.push_back(p.w);
    }
    for (const collision::Shape& s : setup.planes) {
      planes_.push_back({{s.size.x, s.size.y, s.size.z}, s.offset});
    }
    start_ = positions;
    const fluid::ExactKernel exact{setup.kernel.shape, setup.kernel.h};
    for (int k = 0; k <= 10000; ++k) greatest_ = std::max(greatest_, exact.slope(1e-4 * k * exact.h));
  }

  /// C_i = Σ V W − 1 over all particles and their mirror ghosts.
  double error(size_t i) const {
    double density = 0;
    for_each_pair(i, [&](size_t, const Double3&, double r, size_t) { density += weight(r); });
    return density - 1;
  }

  void iterate() {
    std::vector<double> change(positions.size());
    for (size_t i = 0; i < positions.size(); ++i) change[i] = multiplier_change(i);
    std::vector<Double3> next = positions;
    for (size_t i = 0; i < positions.size(); ++i) {
      multipliers[i] += change[i];
      for_each_pair(i, [&](size_t j, const Double3& d, double r, size_t ghost) {
        if (ghost == 0 && j == i) return;
        const double push = inverse_masses_[i] * (change[i] + change[j]) * slope(r) / r;
        for (int k = 0; k < 3; ++k) next[i][k] += push * d[k];
      });
    }
    positions = next;
  }

  std::vector<Double3> positions;
  std::vector<double> multipliers;

 protected:
  /// Δλ_i = max(0, λ_i + ω (C_i − α̃ λ_i)/(D_i + α̃)) − λ_i.
  double multiplier_change(size_t i) const {
    const double dt2 = double{setup_.dt} * setup_.dt, d = denominator(i);
    const double compliance = setup_.parameters.compressibility / (setup_.kernel.particle_volume * dt2);
    double step = setup_.parameters.relaxation * (error(i) - compliance * multipliers[i]) / (d + compliance);
    const double bound = setup_.parameters.correction_limit / std::sqrt(inverse_masses_[i] * d);
    step = std::clamp(step, -bound, bound);
    return std::max(0.0, multipliers[i] + step) - multipliers[i];
  }

  /// D_i = Σ w |∂C_i/∂x|² over i and all others. A particle that moves also moves its mirror ghosts.
  double denominator(size_t i) const {
    std::vector<Double3> gradient(positions.size());
    for_each_pair(i, [&](size_t j, const Double3& d, double r, size_t ghost) {
      if (ghost == 0 && j == i) return;
      const Double3 seen = turned(d, ghost);
      for (int k = 0; k < 3; ++k) {
        gradient[i][k] += slope(r) / r * d[k];
        gradient[j][k] -= slope(r) / r * seen[k];
      }
    });
    double d = 0;
    for (size_t j = 0; j < positions.size(); ++j) d += inverse_masses_[j] * dot(gradient[j], gradient[j]);
    return d;
  }

  double weight(double r) const {
    return setup_.kernel.volume * fluid::ExactKernel{setup_.kernel.shape, setup_.kernel.h}.weight(r);
  }
  /// The factor of the gradient is V where both are one kernel, but for the calibration.
  double slope(double r) const {
    const fluid::ExactKernel exact{setup_.kernel.shape, setup_.kernel.h};
    return setup_.kernel.greatest_slope * exact.slope(r) / greatest_;
  }

  /// Calls visit(j, x_i − x_j, |x_i − x_j|, number of the mirror ghost) for each particle and each mirror
  /// ghost, for every choice of walls at right angles. Neighbours are determined before the first iteration.
  template <class Visit>
  void for_each_pair(size_t i, const Visit& visit) const {
    for (size_t ghost = 0; ghost < (size_t{1} << planes_.size()); ++ghost) {
      if (!near_walls(i, ghost)) continue;
      for (size_t j = 0; j < positions.size(); ++j) {
        if (norm(difference(start_[i], start_[j])) >= setup_.support_radius) continue;
        const Double3 d = difference(positions[i], reflected(positions[j], ghost));
        visit(j, d, norm(d), ghost);
      }
    }
  }

  bool near_walls(size_t i, size_t ghost) const {
    for (size_t p = 0; p < planes_.size(); ++p) {
      if ((ghost >> p & 1) && height(planes_[p], start_[i]) >= setup_.support_radius) return false;
    }
    return true;
  }

  static double dot(const Double3& a, const Double3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static double norm(const Double3& a) { return std::sqrt(dot(a, a)); }
  static double height(const ReferencePlane& p, const Double3& x) { return dot(p.normal, x) - p.offset; }
  static Double3 difference(const Double3& a, const Double3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  /// A direction, as mirrored for the ghost.
  Double3 turned(Double3 d, size_t ghost) const {
    for (size_t p = 0; p < planes_.size(); ++p) {
      if (!(ghost >> p & 1)) continue;
      const double twice = 2 * dot(planes_[p].normal, d);
      for (int k = 0; k < 3; ++k) d[k] -= twice * planes_[p].normal[k];
    }
    return d;
  }

  Double3 reflected(Double3 x, size_t ghost) const {
    for (size_t p = 0; p < planes_.size(); ++p) {
      if (!(ghost >> p & 1)) continue;
      const double twice = 2 * height(planes_[p], x);
      for (int k = 0; k < 3; ++k) x[k] -= twice * planes_[p].normal[k];
    }
    return x;
  }

  const DensityCase& setup_;
  std::vector<ReferencePlane> planes_;
  std::vector<double> inverse_masses_;
  std::vector<Double3> start_;
  double greatest_ = 0;  // of |∇W|
};

}  // namespace meniscus::tests
