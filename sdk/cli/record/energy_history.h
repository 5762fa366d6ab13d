// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <vector>

#include "sdk/cli/record/frame_sample.h"
#include "sdk/scene/scene.h"

namespace meniscus::cli {

/// The height, along up, of the lowest closed container's or level plane's floor, m; none where nothing is
/// below, or without gravity.
std::optional<double> floor_level(const Scene& scene);

/// Mechanical energy over a run. A ratio of energies needs a zero of height that means something: it is the
/// scene's floor, or, without one, the lowest place that a particle reached.
class EnergyHistory {
 public:
  explicit EnergyHistory(const Scene& scene);

  void add(const FrameSample& sample);

  /// Of the last moment, over the first; none without a floor, or where the start has no energy.
  std::optional<double> ratio() const;

  /// start_j, end_j, max_j; end_ratio and max_ratio over the start, null where the start has no energy; and
  /// the zero.
  nlohmann::ordered_json summary() const;

 private:
  struct Moment {
    double from_origin, mass;  // J, kg
  };

  void look_for_lowest(std::span<const Vec3> points);
  double above(double level, const Moment& moment) const;

  double gravity_;  // m/s²
  Vec3 up_;
  std::optional<double> floor_;
  double lowest_;
  std::vector<Moment> moments_;
};

}  // namespace meniscus::cli
