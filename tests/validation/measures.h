// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Measurements of runs for the validation cases. Figures are recorded with the test's result, so that
// --gtest_output=json:FILE contains them.
#pragma once

#include <gtest/gtest.h>
#include <meniscus/meniscus.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

namespace meniscus::tests {

inline void record(const std::string& name, double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", value);
  testing::Test::RecordProperty(name, text);
}

inline void record_device(const World& world) {
  testing::Test::RecordProperty("device", world.device().name);
}

/// The value that is not exceeded by `share` of the values.
inline double percentile(std::vector<float> values, double share) {
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// max(C, 0) of all particles in all frames, and the mean |C| of those inside; in percent.
class DensityErrors {
 public:
  void add(const World& world, const Diagnostics& now) {
    for (float c : world.density_errors()) {
      const float over = 100 * std::max(c, 0.0f);
      values_.push_back(over);
      sum_ += over;
    }
    interior_sum_ += 100 * now.density_error_interior;
    ++frames_;
  }

  double mean() const { return sum_ / static_cast<double>(values_.size()); }
  double p99() const { return percentile(values_, 0.99); }
  double worst() const { return *std::max_element(values_.begin(), values_.end()); }
  double interior() const { return interior_sum_ / frames_; }

  void record_all() const {
    record("density_error_mean_percent", mean());
    record("density_error_p99_percent", p99());
    record("density_error_worst_percent", worst());
    record("density_error_interior_percent", interior());
  }

 private:
  std::vector<float> values_;
  double sum_ = 0, interior_sum_ = 0;
  int frames_ = 0;
};

/// What must hold in every frame of a run: energy that does not grow, and nothing lost. The zero of height is
/// at the scene's floor.
class Watch {
 public:
  explicit Watch(const World& world) : particles_(world.particle_count()) {
    const Diagnostics start = world.diagnostics();
    energy_ = start.kinetic_energy + start.potential_energy;
  }

  void add(const Diagnostics& now) {
    ratio_ = std::max(ratio_, (now.kinetic_energy + now.potential_energy) / energy_);
    outside_ = std::max(outside_, now.outside);
    non_finite_ = std::max(non_finite_, now.non_finite);
    lost_ = std::max(lost_, particles_ - now.particles);
  }

  /// Energy may exceed the start's by 3 %.
  void expect_sound() const {
    record("energy_ratio_max", ratio_);
    record("outside", static_cast<double>(outside_));
    EXPECT_LE(ratio_, 1.03);
    EXPECT_EQ(outside_, 0u);
    EXPECT_EQ(non_finite_, 0u);
    EXPECT_EQ(lost_, 0u);
  }

 private:
  std::size_t particles_;
  double energy_ = 0, ratio_ = 0;
  std::size_t outside_ = 0, non_finite_ = 0, lost_ = 0;
};

}  // namespace meniscus::tests
