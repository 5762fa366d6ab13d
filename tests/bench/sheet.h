// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Times steps of water on cloth: a sheet of 1 m by 1 m, pinned at its four borders, with walls around it and
// a cubic metre of water dropped on it from a spacing above. Says how far the cloth has stretched, and how
// many particles got through it.
#pragma once

#include <CLI/CLI.hpp>

#include "tests/bench/bench.h"

namespace meniscus::bench {

struct SheetOptions {
  std::vector<float> densities{0.2f, 40};  // kg/m², of the fabric
  std::vector<int> substeps{4};            // a frame
  std::vector<int> iterations{4};          // a substep
  std::string solver = "chebyshev";
  bool self_collision = false;
  int n = 100;              // vertices along each side
  int layers = 46;          // of water
  float frame = 1.0f / 60;  // s
  double warm = 0.5;        // s before the clock starts
  double seconds = 10;      // s in all
};

CLI::App* add_sheet(CLI::App& app, SheetOptions& options);
void run_sheet(const CommonOptions& common, const SheetOptions& options, Results& results);

}  // namespace meniscus::bench
