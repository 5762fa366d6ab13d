// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace meniscus::cli {

struct CheckOptions {
  std::string scene;  ///< a file, or a sample's name
  std::vector<std::string> overrides;
};

/// Reads a scene and builds its world on the CPU; prints what is in it. Throws Error where it is not valid.
int check_scene(const CheckOptions& options);

}  // namespace meniscus::cli
