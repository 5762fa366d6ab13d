// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements the limit on a command's time.
#include "sdk/cli/stop/run_budget.h"

#include <spdlog/fmt/fmt.h>

namespace meniscus::cli {

RunBudget::RunBudget(double minutes) : minutes_(minutes) {}

bool RunBudget::spent() const {
  const std::chrono::duration<double, std::ratio<60>> used = Clock::now() - start_;
  return interrupted() || (minutes_ > 0 && used.count() >= minutes_);
}

std::string RunBudget::reason() const {
  if (interrupted()) return "A signal ended the command before all was measured.";
  if (spent())
    return fmt::format("The limit of {:g} minutes ended the command before all was measured.", minutes_);
  return "";
}

}  // namespace meniscus::cli
