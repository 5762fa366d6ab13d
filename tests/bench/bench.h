// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Types and functions that all cases of the benchmark share.
#pragma once

#include <meniscus/meniscus.h>

#include <CLI/CLI.hpp>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "pbd/ranks/ranks.h"

namespace meniscus::bench {

using Json = nlohmann::ordered_json;

struct CommonOptions {
  std::string device = "auto";
  int threads = 0;
  std::string commit, date, out;
  pbd::Ranks* ranks = nullptr;  ///< that share each world; null: one process alone

  bool leads() const { return !ranks || ranks->rank() == 0; }
};

/// A world's definition on the device that was asked for.
WorldDef world_def(const CommonOptions& options);

/// A density solver by its name, and what checks that an option is one.
DensitySolver solver_named(const std::string& name);
CLI::IsMember is_solver();

/// The smallest value that is not exceeded by `share` of the others; 0.5 gives the median.
double quantile(std::vector<double> values, double share);

/// What timed steps took.
class StepTimes {
 public:
  void add(const StepReport& report);
  double median_ms() const { return quantile(ms_, 0.5); }
  double p99_ms() const { return quantile(ms_, 0.99); }
  double rigid_ms() const { return quantile(rigid_ms_, 0.5); }
  double density_iterations() const { return quantile(density_iterations_, 0.5); }
  Json stage_ms() const;  ///< medians

 private:
  std::vector<double> ms_, rigid_ms_, density_iterations_;
  std::array<std::vector<double>, stage_count> stages_;
};

/// Prints results as they come, and writes them all to a file. Of several ranks the first does.
class Results {
 public:
  /// The command is noted as well, but for where the file goes, which says nothing about what is in it.
  Results(const CommonOptions& options, int argc, char** argv);
  void add(const Json& result);
  void write() const;

 private:
  std::string out_;
  bool leads_;
  Json all_;
};

}  // namespace meniscus::bench
