// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements the checks that a run keeps its inputs.
#include "sdk/cli/commands/run_files.h"

#include <meniscus/error.h>

#include <string>
#include <utility>
#include <vector>

#include "sdk/cli/output/old_results.h"

namespace meniscus::cli {
namespace {

namespace fs = std::filesystem;

using NamedFile = std::pair<std::string, fs::path>;

fs::path whole(const fs::path& path) {
  std::error_code unknown;  // then a later call says what is wrong with it
  fs::path resolved = fs::weakly_canonical(path, unknown);
  return unknown ? path : resolved;
}

std::vector<NamedFile> inputs_of(const RunOptions& options) {
  std::vector<NamedFile> inputs{{"the scene", scene_path(options.scene.scene)}};
  if (!options.from.empty()) inputs.emplace_back("the snapshot of --from", options.from);
  return inputs;
}

}  // namespace

void expect_files_apart(const RunOptions& options) {
  std::vector<NamedFile> files = inputs_of(options);
  for (const NamedFile& output :
       {NamedFile{"--record", options.record}, {"--video", options.picture.video}}) {
    if (output.second.empty()) continue;
    for (const auto& [name, path] : files) {
      if (whole(path) == whole(output.second))
        throw Error(ErrorCode::invalid_argument,
                    output.first + " " + output.second.string() + " would replace " + name);
    }
    files.push_back(output);
  }
}

fs::path results_folder(const RunOptions& options, const Scene& scene) {
  fs::path folder = options.out.empty() ? default_folder(scene) : fs::path(options.out);
  for (const auto& [name, path] : inputs_of(options)) {
    if (is_result(whole(path), whole(folder)))
      throw Error(ErrorCode::invalid_argument, "results in " + folder.string() + " would replace " + name +
                                                   ", " + path.string() + ": --out names another folder");
  }
  return folder;
}

}  // namespace meniscus::cli
