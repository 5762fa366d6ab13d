// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sdk/cli/record/csv_file.h"
#include "sdk/cli/record/frame_sample.h"

namespace meniscus::cli {

/// frames.csv: a row a frame, on disk as soon as it is known.
class FrameTable {
 public:
  /// Throws Error(io).
  FrameTable(std::filesystem::path path, const std::vector<std::string>& probe_names);

  /// Throws Error(io).
  void add(const FrameSample& sample);

 private:
  CsvFile file_;
};

}  // namespace meniscus::cli
