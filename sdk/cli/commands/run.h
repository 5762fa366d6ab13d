// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sdk/cli/commands/scene_lookup.h"
#include "sdk/cli/output/picture_options.h"

namespace meniscus::cli {

struct RunOptions {
  SceneChoice scene;
  std::optional<int> frames;
  std::string out;  ///< empty: out/<scene name>
  std::vector<std::string> formats;
  bool surface = false;  ///< of the fluids, too, in these formats
  PictureOptions picture;
  bool quiet = false;
};

/// Runs a scene and writes what came of it; returns an exit code. Throws Error where nothing was run: for bad
/// input, an output folder that cannot be used, or a device that is not there.
int run_scene(const RunOptions& options);

}  // namespace meniscus::cli
