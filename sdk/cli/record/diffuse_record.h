// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The figures of a run's spray, foam and bubbles.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <meniscus/scene.h>
#include "sdk/cli/record/frame_sample.h"

namespace meniscus::cli {

/// Diffuse particles by their kind.
struct DiffuseCounts {
  std::size_t spray = 0, foam = 0, bubbles = 0;

  std::size_t all() const { return spray + foam + bubbles; }
};

DiffuseCounts counts_of(const io::DiffuseFrame& diffuse);

/// Counts of diffuse particles over a run.
class DiffuseRecord {
 public:
  explicit DiffuseRecord(const Scene& scene) : any_(scene.world.diffuse.has_value()) {}

  /// The state after a step.
  void add(const FrameSample& sample);
  /// The last counts, the most of any frame, and those that were not made for lack of room. Null for a scene
  /// that makes none.
  nlohmann::ordered_json summary() const;

 private:
  bool any_;
  DiffuseCounts last_;
  std::size_t most_ = 0;
  uint64_t refused_ = 0;
};

}  // namespace meniscus::cli
