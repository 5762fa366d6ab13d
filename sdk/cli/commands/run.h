// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command `meniscus run`.
#pragma once

#include <cstdint>
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
  bool surface = false;  ///< also writes the surfaces of the fluids, in these formats
  PictureOptions picture;
  std::optional<int> save_every;  ///< frames from one snapshot to the next
  std::string from;               ///< a snapshot to continue from; empty: the start
  std::string record;             ///< the file for a recording; empty: none
  std::string cuts = "auto";      ///< of a world that ranks share
  std::optional<int> worlds;      ///< as many copies, as a batch
  std::vector<std::string> vary;  ///< with `worlds`: path=low:high of what differs among them
  uint64_t seed = 1;              ///< of these values
  bool quiet = false;
  bool json = false;  ///< prints what summary.json contains, and the folder
};

/// Runs a scene and writes its results; returns an exit code. Throws Error if nothing was run: for bad input,
/// an output folder that cannot be used, or a missing device.
int run_scene(const RunOptions& options);

}  // namespace meniscus::cli
