// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Times steps of cloth, and says how far it has stretched by the end: the stiffer it is to be, the more a
// step costs. A sheet of 2 m by 2 m and .2 kg/m² either hangs by its top row from the start, or is dropped on
// a ball above a floor.
#pragma once

#include <CLI/CLI.hpp>

#include "tests/bench/bench.h"

namespace meniscus::bench {

struct ClothOptions {
  std::vector<int> n{100};        // vertices along each side
  std::vector<int> substeps{10};  // a step
  std::vector<int> iterations{1};
  double dt = 1.0 / 60;  // s
  double warm = 0.5;     // s before the clock starts
  double seconds = 10;   // s in all
  bool tethers = true;
  bool self_collision = false;
  bool count_intersections = false;
  std::string stretch = "edges";
  FabricDef fabric{};
  ClothSolverDef solver{};
};

/// Their options have the same names, and defaults of their own.
CLI::App* add_hanging(CLI::App& app, ClothOptions& options);
CLI::App* add_drape(CLI::App& app, ClothOptions& options);
void run_hanging(const CommonOptions& common, const ClothOptions& options, Results& results);
void run_drape(const CommonOptions& common, const ClothOptions& options, Results& results);

}  // namespace meniscus::bench
