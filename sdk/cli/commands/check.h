// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command `meniscus check`.
#pragma once

#include <string>
#include <vector>

namespace meniscus::cli {

struct CheckOptions {
  std::string scene;  ///< a file or the name of a sample
  std::vector<std::string> overrides;
  bool json = false;  ///< prints JSON
};

/// Reads a scene, builds its world on the CPU, and prints its contents. Throws Error if the scene is not
/// valid.
int check_scene(const CheckOptions& options);

}  // namespace meniscus::cli
