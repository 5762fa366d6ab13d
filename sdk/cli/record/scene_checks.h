// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The checks that a scene states about its own run.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include <meniscus/scene.h>
#include "sdk/cli/record/cloth_crossings.h"
#include "sdk/cli/record/frame_sample.h"

namespace meniscus::cli {

/// Throws Error(invalid_argument) if a check is of energy, but there is no floor to measure it from.
void expect_floor(const Scene& scene);

/// Evaluates after every frame whether the checks of the scene hold.
class SceneChecks {
 public:
  /// `scene` must outlive this. Throws what expect_floor throws.
  explicit SceneChecks(const Scene& scene);

  /// The state before the first step.
  void start(const FrameSample& sample);
  /// The state after a step; `energy` is relative to that at the start, if it is known.
  void add(const FrameSample& sample, std::optional<double> energy);

  /// For each check: name, type, unit, low and high (null: any), the smallest and largest observed value, and
  /// its state. The state is "held", "broken" with broken_at_s, or "not reached" if the run ended before a
  /// frame counted.
  nlohmann::ordered_json summary() const;

 private:
  struct Seen {
    std::size_t body = 0, cloth = 0, probe = 0;  // indices of the observed objects
    double start_volume = 0;                     // m³, of the cloth
    std::size_t tears = 0;
    bool reached = false;
    double least = 0, most = 0;
    std::optional<double> broken_at;  // s
  };

  double value(const SceneCheck& check, const Seen& seen, const FrameSample& sample,
               std::optional<double> energy) const;
  double tilt(const BodyState& body) const;

  const Scene& scene_;
  std::vector<Seen> seen_;  // one per check
  std::optional<ClothCrossings> crossings_;
};

}  // namespace meniscus::cli
