// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command `meniscus validate`.
#pragma once

#include <string>
#include <vector>

namespace meniscus::cli {

struct ValidateOptions {
  std::vector<std::string> cases;  ///< names; empty: all
  bool list = false;               ///< only list the cases
  std::string device = "auto";     ///< auto, cpu or cuda
  int threads = 0;                 ///< of the CPU device; 0: one for each core
  std::string resolution = "medium";
  std::string output;  ///< folder; empty: out/validate
  std::string page;    ///< a second place for the page; empty: none
  std::string commit;  ///< what the page says that the build is from
};

/// Runs cases of validation, prints their figures, and writes accuracy.md with drawings and figures. Returns
/// run_failed if a hard gate is missed or a run fails. Throws Error.
int validate_cases(const ValidateOptions& options);

}  // namespace meniscus::cli
