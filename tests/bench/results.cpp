// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Options and statistics that all benchmarks share.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>

#include "sdk/fields/world.h"
#include "sdk/ranks/launcher.h"
#include "tests/bench/bench.h"

namespace meniscus::bench {

WorldDef world_def(const CommonOptions& options) {
  WorldDef def;
  if (options.device == "cpu") def.device = DeviceChoice::cpu;
  if (options.device == "cuda") def.device = DeviceChoice::cuda;
  def.threads = options.threads;
  if (options.ranks && options.device != "cpu") def.cuda_device = process_of_host();
  return def;
}

DensitySolver solver_named(const std::string& name) {
  for (const auto& [text, solver] : names_of(DensitySolver{})) {
    if (name == text) return solver;
  }
  return DensitySolver::chebyshev;
}

CLI::IsMember is_solver() {
  std::vector<std::string> names;
  for (const auto& named : names_of(DensitySolver{})) names.push_back(named.name);
  return CLI::IsMember(names);
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto place = static_cast<size_t>(share * static_cast<double>(values.size()));
  const auto at = values.begin() + static_cast<long>(std::min(place, values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

void StepTimes::add(const StepReport& report) {
  ms_.push_back(report.ms);
  rigid_ms_.push_back(report.rigid_ms);
  density_iterations_.push_back(report.density_iterations);
  for (size_t s = 0; s < stages_.size(); ++s) stages_[s].push_back(report.stage_ms[s]);
}

Json StepTimes::stage_ms() const {
  Json medians;
  for (size_t s = 0; s < stages_.size(); ++s) medians[stage_name(Stage(s))] = quantile(stages_[s], 0.5);
  return medians;
}

Results::Results(const CommonOptions& options, int argc, char** argv)
    : out_(options.out), leads_(options.leads()) {
  std::string command = "bench";
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--out")
      ++i;
    else if (!argument.starts_with("--out="))
      command += " " + argument;
  }
  all_ = {{"command", command},
          {"date", options.date},
          {"commit", options.commit},
          {"device", World(world_def(options)).device().name},
          {"results", Json::array()}};
}

void Results::add(const Json& result) {
  if (!leads_) return;
  all_["results"].push_back(result);
  std::cout << result.dump() << std::endl;
}

void Results::write() const {
  if (leads_ && !out_.empty()) std::ofstream(out_) << all_.dump(2) << "\n";
}

}  // namespace meniscus::bench
