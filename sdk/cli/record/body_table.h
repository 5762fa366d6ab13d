// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The table bodies.csv of a run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sdk/cli/record/csv_file.h"
#include "sdk/cli/record/frame_sample.h"

namespace meniscus::cli {

/// bodies.csv: one row per frame and body. Position (m) and rotation (a quaternion) are of the geometry's
/// frame. Velocity (m/s) is of the centre of mass, torque (N·m) about it. Angular velocity is in rad/s. Force
/// (N) and torque are the fluid's.
class BodyTable {
 public:
  /// Throws Error(io).
  BodyTable(std::filesystem::path path, std::vector<std::string> names);

  /// Throws Error(io).
  void add(const FrameSample& sample);

 private:
  CsvFile file_;
  std::vector<std::string> names_;
};

}  // namespace meniscus::cli
