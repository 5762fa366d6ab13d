// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the paper reports: Macklin & Müller 2013, Position Based Fluids, tables 1 and 2, on a GTX 680.
#pragma once

namespace meniscus::cli::pbf {

/// A row of table 1. All frames last 16 ms.
struct PaperTime {
  const char* label;
  const char* sample;  ///< the scene here
  int particles, substeps, iterations;
  double ms;  ///< a step
};

inline constexpr PaperTime paper_times[] = {{"Armadillo splash", "armadillo_splash", 128'000, 2, 3, 4.2},
                                            {"Dam break", "dam_break", 100'000, 4, 3, 4.3},
                                            {"Bunny drop", "bunny_drop", 80'000, 4, 10, 7.8}};

/// Table 2, in percent of a frame.
struct PaperShares {
  const char* sample;
  double integrate, grid, neighbours, solve, velocity;
};

inline constexpr PaperShares paper_shares[] = {{"armadillo_splash", 1, 8, 28, 38, 25},
                                               {"dam_break", 1, 6, 28, 51, 14}};

inline constexpr const char* paper_card = "GTX 680";

}  // namespace meniscus::cli::pbf
