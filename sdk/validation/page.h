// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The page on all cases that were run: Markdown, with a drawing for each plot, and JSON.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sdk/validation/case.h"

namespace meniscus::validation {

/// A case that was run.
struct Record {
  Case of;
  Result result;
  double seconds = 0;   ///< wall clock
  std::string failure;  ///< what ended the run; empty: nothing did

  /// Nothing failed, and no hard gate is missed.
  bool passes() const;
};

struct PageHead {
  std::string device;                  ///< its name
  std::string resolution;              ///< quick, medium or full
  std::string commit;                  ///< of the build; may be empty
  std::vector<std::string> missing{};  ///< what there is no case for, and why: sentences
};

/// "held", "missed", or "MISSED" if the gate is hard.
const char* verdict_of(const Gate& gate);
/// A figure as it is printed, with its unit.
std::string printed(double value, const std::string& unit);
/// The interval that the gate allows.
std::string interval_of(const Gate& gate);

/// Writes the page, and drawings and figures.json into the folder beside it that has its name. Throws
/// Error(io).
void write_page(const std::filesystem::path& page, const PageHead& head, const std::vector<Record>& records);

}  // namespace meniscus::validation
