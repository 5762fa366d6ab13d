// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sdk/cli/record/csv_file.h"
#include "sdk/cli/record/frame_sample.h"

namespace meniscus::cli {

/// bodies.csv: a row a frame and body. Position (m) and rotation (a quaternion) are of the geometry's frame,
/// velocity (m/s) and torque (N·m) of and about the centre of mass; angular velocity in rad/s; force (N) and
/// torque are the fluid's.
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
