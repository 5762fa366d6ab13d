// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Times the surface mesh of a ball of liquid, and says how far its volume is off.
#pragma once

#include <CLI/CLI.hpp>

#include "tests/bench/bench.h"

namespace meniscus::bench {

struct SurfaceOptions {
  std::vector<int> particles{100000};
  float cell_size = 0.5f;  ///< spacings
  int times = 20;
};

CLI::App* add_surface(CLI::App& app, SurfaceOptions& options);
void run_surface(const CommonOptions& common, const SurfaceOptions& options, Results& results);

}  // namespace meniscus::bench
