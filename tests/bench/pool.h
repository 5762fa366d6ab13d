// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Times steps of a pool at rest, and says how far its depth has pressed it together.
#pragma once

#include <CLI/CLI.hpp>

#include "tests/bench/bench.h"

namespace meniscus::bench {

struct PoolOptions {
  std::vector<int> particles{100000};
  std::vector<int> iterations{4};
  int layers = 40;
  int substeps = 1;
  float frame = 1.0f / 60;    // s
  float settle_seconds = 4;   // before the clock starts
  float measure_seconds = 2;  // over which the density is averaged
  std::string solver = "chebyshev";
};

CLI::App* add_pool(CLI::App& app, PoolOptions& options);
void run_pool(const CommonOptions& common, const PoolOptions& options, Results& results);

}  // namespace meniscus::bench
