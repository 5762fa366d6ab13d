// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Times steps of a batch of small dam breaks.
#pragma once

#include <CLI/CLI.hpp>

#include "tests/bench/bench.h"

namespace meniscus::bench {

struct BatchOptions {
  std::vector<int> worlds{1024};
  int particles = 1000;  // of each world, about
  int bodies = 0;        // of each world
  int cloth = 0;         // vertices along each side of its sheet
  int rigid_threads = 0;
  int batches = 1;
  int substeps = 4;
  int iterations = 4;
  int steps = 60;    // that are timed
  double reset = 0;  // share of the worlds that are reset before each step
  float frame = 1.0f / 60;
};

CLI::App* add_batch(CLI::App& app, BatchOptions& options);
void run_batch(const CommonOptions& common, const BatchOptions& options, Results& results);

}  // namespace meniscus::bench
