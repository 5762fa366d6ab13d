// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command `meniscus compare`.
#pragma once

#include <string>
#include <vector>

#include "sdk/cli/commands/scene_lookup.h"

namespace meniscus::cli {

struct CompareOptions {
  SceneChoice scene;
  std::vector<double> errors{0.05, 0.1, 0.5, 1};  ///< %, means of max(C, 0)
  double seconds = 1;                             ///< of simulated time
  std::vector<int> substeps;                      ///< to try; empty: the scene's number
  bool stability = true;                          ///< search for the largest stable steps
  double minutes = 0;                             ///< limit on the wall clock; 0: none
  std::string out;                                ///< folder; empty: out/<scene name>
  bool json = false;                              ///< prints what compare.json contains, instead of the table
};

/// Runs a scene of fluids and bodies with each density solver at each mean density error, and searches for
/// the largest stable steps. Writes times, errors, memory and steps as compare.md, compare.json and
/// compare.svg, after each run. What is done stays written if the command ends early. Throws Error.
int compare_solvers(const CompareOptions& options);

}  // namespace meniscus::cli
