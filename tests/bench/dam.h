// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Times steps of a dam break and says what the solve was worth: a speed without its density error says
// nothing.
#pragma once

#include <CLI/CLI.hpp>

#include "tests/bench/bench.h"

namespace meniscus::bench {

struct DamOptions {
  std::vector<int> particles{100000};
  std::vector<int> iterations{4};
  int substeps = 1;
  int boxes = 0;
  bool device_contacts = false;
  bool diffuse = false;
  bool fixed_sums = false;
  int warm_steps = 200;
  int timed_steps = 200;
  float step_in_h =
      0.2f;  // how far, in support radii, a particle falling from the dam's top may move in a substep
  std::string solver = "chebyshev";
  float tolerance = 0;
};

/// A block of water, a third of its tank, with edges as 5 to 4 to 5; support radius of two spacings.
struct Dam {
  World world;
  ShapeDef tank;
  float dt;

  Dam(const CommonOptions& common, const DamOptions& options, int particles, int iterations);
};

CLI::App* add_dam(CLI::App& app, DamOptions& options);
void run_dam(const CommonOptions& common, const DamOptions& options, Results& results);

}  // namespace meniscus::bench
