// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Times pictures of a dam break in mid-splash, pass by pass.
#pragma once

#include <CLI/CLI.hpp>

#include "tests/bench/dam.h"

namespace meniscus::bench {

struct RenderOptions {
  DamOptions dam{.warm_steps = 400};  ///< for 100,000 particles, and longer for more
  int width = 1920, height = 1080;
  int frames = 60;
  std::string picture;  ///< a PNG file to keep one in
};

CLI::App* add_render(CLI::App& app, RenderOptions& options);
void run_render(const CommonOptions& common, const RenderOptions& options, Results& results);

}  // namespace meniscus::bench
