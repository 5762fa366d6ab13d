// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A substep of each baseline, directly from its formulas, as in density_reference.h. Walls are at rest.
#pragma once

#include "fluid/baselines/tuning.h"
#include "tests/unit/fluid/density_reference.h"

namespace meniscus::tests {

class BaselineReference : public DensityReference {
 public:
  explicit BaselineReference(const DensityCase& setup) : DensityReference(setup), count_(positions.size()) {
    for (const Vec3& v : setup.velocities) velocities.push_back({v.x, v.y, v.z});
    velocities.resize(count_);
  }

  void solve() {
    if (setup_.parameters.method == fluid::DensityMethod::wcsph) return solve_wcsph();
    const bool dfsph = setup_.parameters.method == fluid::DensityMethod::dfsph;
    std::vector<double> step(count_);
    const double lightest = *std::max_element(inverse_masses_.begin(), inverse_masses_.end());
    for (size_t i = 0; i < count_; ++i)
      step[i] = 0.5 / (dfsph ? denominator(i) : lightest * setup_.kernel.rest_gradient2);
    solve_density(step);
    if (dfsph) solve_divergence();
  }

  std::vector<Double3> velocities;

 private:
  using Values = std::vector<double>;

  /// Iterations with the gradients of the start, and C at the predicted positions.
  void solve_density(const Values& step) {
    const std::vector<Double3> frozen = positions;
    std::vector<Double3> predicted = positions;
    for (int iteration = 0; iteration < setup_.iterations; ++iteration) {
      positions = predicted;
      Values compression(count_);
      for (size_t i = 0; i < count_; ++i) compression[i] = error(i);
      positions = frozen;
      add(pushes(relaxed(multipliers, step, compression)), 1, predicted);
    }
    for (size_t i = 0; i < count_; ++i) {
      for (size_t k = 0; k < 3; ++k) velocities[i][k] += (predicted[i][k] - frozen[i][k]) / setup_.dt;
    }
    positions = predicted;
  }

  void solve_divergence() {
    Values step(count_), divergence(count_), multiplier(count_);
    for (size_t i = 0; i < count_; ++i) step[i] = 0.5 / denominator(i);
    for (int iteration = 0; iteration < setup_.iterations; ++iteration) {
      for (size_t i = 0; i < count_; ++i) divergence[i] = setup_.dt * compression_rate(i);
      add(pushes(relaxed(multiplier, step, divergence)), 1.0 / setup_.dt, velocities);
    }
    for (size_t i = 0; i < count_; ++i) multipliers[i] += multiplier[i];
  }

  /// dC_i/dt, of a particle with enough neighbours.
  double compression_rate(size_t i) const {
    double rate = 0, neighbours = 0;
    for_each_pair(i, [&](size_t j, const Double3& d, double r, size_t ghost) {
      if (ghost == 0 && j == i) return;
      neighbours += r < setup_.support_radius;
      rate -= slope(r) / r * dot(d, difference(velocities[i], turned(velocities[j], ghost)));
    });
    return neighbours < fluid::baseline_tuning::least_neighbours ? 0 : rate;
  }

  void solve_wcsph() {
    const double dt2 = double{setup_.dt} * setup_.dt, volume = setup_.kernel.volume;
    const double modulus = 1 / double{setup_.parameters.compressibility};
    const double sound =
        std::sqrt(modulus * volume * *std::max_element(inverse_masses_.begin(), inverse_masses_.end()));
    Values staged(count_);
    for (size_t i = 0; i < count_; ++i) {
      const double ratio = 1 + error(i);
      multipliers[i] = volume * dt2 * modulus / 7 * std::max(0.0, std::pow(ratio, 7) - 1);
      staged[i] = multipliers[i] / (ratio * ratio);
    }
    std::vector<Double3> change(count_);
    for (size_t i = 0; i < count_; ++i) change[i] = viscous_change(i, sound);
    add(change, 1, velocities);
    add(pushes(staged), 1.0 / setup_.dt, velocities);
  }

  /// −h_t Σ m_j Π_ij ∇W, Π = −2 α η c/(ρ_i + ρ_j) v·d/(d² + 0.01 η²) where they approach, η = h/2.
  Double3 viscous_change(size_t i, double sound) const {
    const double eta = 0.5 * setup_.support_radius, volume = setup_.kernel.volume;
    Double3 change{};
    for_each_pair(i, [&](size_t j, const Double3& d, double r, size_t ghost) {
      if (ghost != 0 || j == i) return;
      const double approach = std::max(0.0, -dot(difference(velocities[i], velocities[j]), d));
      const double mass = 1 / inverse_masses_[j];
      const double densities = (1 / inverse_masses_[i] + mass) / volume;
      const double viscosity = 2 * double{fluid::baseline_tuning::artificial_viscosity} * eta * sound /
                               densities * approach / (r * r + 0.01 * eta * eta);
      for (size_t k = 0; k < 3; ++k) change[k] += setup_.dt * mass * viscosity * slope(r) / volume * d[k] / r;
    });
    return change;
  }

  /// Raises the multipliers, and returns their changes.
  Values relaxed(Values& multiplier, const Values& step, const Values& compression) const {
    Values change(count_);
    for (size_t i = 0; i < count_; ++i) {
      const double next = std::max(0.0, multiplier[i] + step[i] * compression[i]);
      change[i] = next - multiplier[i];
      multiplier[i] = next;
    }
    return change;
  }

  std::vector<Double3> pushes(const Values& staged) const {
    std::vector<Double3> push(count_);
    for (size_t i = 0; i < count_; ++i) {
      for_each_pair(i, [&](size_t j, const Double3& d, double r, size_t ghost) {
        if (ghost == 0 && j == i) return;
        const double size = inverse_masses_[i] * (staged[i] + staged[j]) * slope(r) / r;
        for (size_t k = 0; k < 3; ++k) push[i][k] += size * d[k];
      });
    }
    return push;
  }

  static void add(const std::vector<Double3>& change, double scale, std::vector<Double3>& to) {
    for (size_t i = 0; i < to.size(); ++i) {
      for (size_t k = 0; k < 3; ++k) to[i][k] += scale * change[i][k];
    }
  }

  size_t count_;
};

}  // namespace meniscus::tests
