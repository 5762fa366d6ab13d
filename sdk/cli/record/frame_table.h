// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The table frames.csv of a run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sdk/cli/record/csv_file.h"
#include "sdk/cli/record/frame_sample.h"

namespace meniscus::cli {

/// frames.csv: one row per frame, written to disk at once.
class FrameTable {
 public:
  /// Throws Error(io).
  FrameTable(std::filesystem::path path, const std::vector<std::string>& probe_columns);

  /// Throws Error(io).
  void add(const FrameSample& sample);

 private:
  CsvFile file_;
};

}  // namespace meniscus::cli
