// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Where a run writes, and which files it may not replace.
#pragma once

#include <filesystem>

#include "sdk/cli/commands/run.h"

namespace meniscus::cli {

/// Throws Error(invalid_argument) if the recording or the video would replace the scene, the snapshot to
/// continue from, or one another.
void expect_files_apart(const RunOptions& options);

/// The folder for the results of a run. Throws Error(invalid_argument) if they would replace the scene or the
/// snapshot.
std::filesystem::path results_folder(const RunOptions& options, const Scene& scene);

}  // namespace meniscus::cli
