// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Times snapshots of a dam break, and what goes back to them.
#pragma once

#include <CLI/CLI.hpp>

#include "tests/bench/bench.h"

namespace meniscus::bench {

struct SnapshotOptions {
  std::vector<int> particles{1000000};
  int repeats = 20;
};

CLI::App* add_snapshot(CLI::App& app, SnapshotOptions& options);
void run_snapshot(const CommonOptions& common, const SnapshotOptions& options, Results& results);

}  // namespace meniscus::bench
