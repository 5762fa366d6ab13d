// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The figures of a run: its tables, summary.json and density.svg.
#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sdk/cli/record/body_table.h"
#include "sdk/cli/record/cloth_record.h"
#include "sdk/cli/record/diffuse_record.h"
#include "sdk/cli/record/energy_history.h"
#include "sdk/cli/record/frame_table.h"
#include "sdk/cli/record/histogram.h"
#include "sdk/cli/record/scene_checks.h"

namespace meniscus::cli {

/// How a run ended.
struct RunEnd {
  bool interrupted = false;
  std::string error;  ///< empty: none
  uint64_t state_hash = 0;
  std::size_t device_bytes = 0;
};

/// Records the figures of a run. It writes frames.csv during the run, and bodies.csv, cloths.csv and
/// attachments.csv if the scene has any. It writes summary.json at the end, and density.svg if the scene has
/// a fluid.
class RunRecorder {
 public:
  /// `scene` must outlive the recorder. Throws Error(io) if the folder cannot be written to, and what
  /// SceneChecks throws.
  RunRecorder(std::filesystem::path folder, const Scene& scene);

  /// The state before the first step; `masses` in the order of the scene's bodies.
  void start(const DeviceInfo& device, const FrameSample& sample, std::vector<BodyMass> masses = {});
  /// The state after a step. Throws Error(io).
  void add(const FrameSample& sample);
  /// Writes the files; returns the contents of summary.json. Throws Error(io).
  nlohmann::ordered_json finish(const RunEnd& end);

 private:
  nlohmann::ordered_json summary(const RunEnd& end) const;
  nlohmann::ordered_json times() const;
  nlohmann::ordered_json density() const;
  nlohmann::ordered_json probes() const;
  nlohmann::ordered_json bodies() const;
  nlohmann::ordered_json overflows() const;

  std::filesystem::path folder_;
  const Scene& scene_;
  FrameTable table_;
  std::optional<BodyTable> body_table_;
  ClothRecord cloth_;
  DiffuseRecord diffuse_;
  EnergyHistory energy_;
  SceneChecks checks_;
  Histogram density_error_;
  std::vector<std::string> body_names_;
  DeviceInfo device_;
  std::vector<BodyMass> masses_;

  // One element per frame.
  std::vector<double> time_, density_mean_, density_max_, step_ms_;
  std::array<std::vector<double>, stage_count> stage_ms_;

  // Over all frames so far.
  double density_sum_ = 0, interior_sum_ = 0, density_iterations_ = 0;
  uint64_t substeps_ = 0, removed_ = 0, emitted_ = 0;
  std::size_t outside_ = 0, non_finite_ = 0, wall_overflows_ = 0;
  Overflows overflows_;

  // Of the last frame.
  StepReport step_;
  Diagnostics diagnostics_;
  std::vector<uint64_t> emitted_by_, taken_by_;
  std::vector<double> probes_;
  std::vector<BodyState> bodies_;
};

/// By nearest rank; 0 without values.
double percentile(std::vector<double> values, double share);

}  // namespace meniscus::cli
