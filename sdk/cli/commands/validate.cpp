// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus validate`: cases against theory and experiment.
#include "sdk/cli/commands/validate.h"

#include <meniscus/error.h>
#include <meniscus/world.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/output/frame_exporter.h"
#include "sdk/validation/cases/registry.h"
#include "sdk/validation/page.h"

namespace meniscus::cli {
namespace {

using namespace validation;

Settings settings_of(const ValidateOptions& options) {
  Settings settings;
  settings.device = options.device == "cuda"  ? DeviceChoice::cuda
                    : options.device == "cpu" ? DeviceChoice::cpu
                                              : DeviceChoice::automatic;
  settings.threads = options.threads;
  settings.resolution = options.resolution == "quick"    ? Resolution::quick
                        : options.resolution == "medium" ? Resolution::medium
                                                         : Resolution::full;
  return settings;
}

/// A run that fails is a result.
Record record_of(const Case& chosen, const Settings& settings) {
  Record record{chosen, {}, 0, {}};
  const auto start = std::chrono::steady_clock::now();
  try {
    record.result = chosen.run(settings);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::non_finite && error.code() != ErrorCode::out_of_memory) throw;
    record.failure = error.what();
  }
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return record;
}

void print(const Record& record) {
  fmt::print("{} ({:.1f} s)\n", record.of.name, record.seconds);
  if (!record.failure.empty()) fmt::print("  failed: {}\n", record.failure);
  for (const Gate& gate : record.result.gates)
    fmt::print("  {:6} {}: {} ({} {})\n", verdict_of(gate), gate.name, printed(gate.value, gate.unit),
               gate.bar == Bar::hard ? "gate" : "target", interval_of(gate));
  for (const Figure& figure : record.result.figures)
    fmt::print("         {}: {}\n", figure.name, printed(figure.value, figure.unit));
  std::fflush(stdout);
}

int list_cases() {
  for (const Case& c : all_cases()) fmt::print("{:20} {}\n", c.name, c.title);
  return success;
}

}  // namespace

int validate_cases(const ValidateOptions& options) {
  if (options.list) return list_cases();
  const std::vector<Case> chosen = chosen_cases(options.cases);
  const std::filesystem::path folder = options.output.empty() ? std::filesystem::path("out") / "validate"
                                                              : std::filesystem::path(options.output);
  make_folder(folder);
  const Settings settings = settings_of(options);
  const PageHead head{World(settings.world(1)).device().name, options.resolution, options.commit,
                      missing_cases()};
  std::vector<Record> records;
  for (const Case& c : chosen) {
    records.push_back(record_of(c, settings));
    print(records.back());
    write_page(folder / "accuracy.md", head, records);
  }
  if (!options.page.empty()) write_page(options.page, head, records);
  const bool passes = std::all_of(records.begin(), records.end(), [](const Record& r) { return r.passes(); });
  return passes ? success : run_failed;
}

}  // namespace meniscus::cli
