// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The mechanical energy of a run over time.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <vector>

#include <meniscus/scene.h>
#include "sdk/cli/record/frame_sample.h"

namespace meniscus::cli {

/// The height (m, along up) of the lowest floor of a closed container or of a level plane. Nothing if there
/// is none, or without gravity.
std::optional<double> floor_level(const Scene& scene);

/// Mechanical energy over a run. A ratio of energies needs a meaningful zero of height. It is the scene's
/// floor, or, without one, the lowest place that a particle has reached.
class EnergyHistory {
 public:
  explicit EnergyHistory(const Scene& scene);

  void add(const FrameSample& sample);

  /// The last energy over the first. Nothing without a floor, or if the first energy is 0.
  std::optional<double> ratio() const;

  /// start_j, end_j and max_j; end_ratio and max_ratio over the start, null if the start energy is 0; and the
  /// zero of height.
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
