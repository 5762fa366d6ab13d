// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Which files a run may not replace.
#pragma once

#include <filesystem>

#include "sdk/cli/commands/run.h"

namespace meniscus::cli {

/// Throws Error(invalid_argument) if the recording or the video would replace the scene, the snapshot to
/// continue from, or one another.
void expect_files_apart(const RunOptions& options);

/// Throws Error(invalid_argument) if results in the folder would replace the scene or the snapshot.
void expect_inputs_kept(const RunOptions& options, const std::filesystem::path& folder);

}  // namespace meniscus::cli
