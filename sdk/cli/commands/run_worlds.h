// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command `meniscus run` with --worlds.
#pragma once

#include "sdk/cli/commands/run.h"

namespace meniscus::cli {

/// Runs copies of a scene as a batch, and writes what has become of each; returns an exit code. Throws Error
/// if nothing was run.
int run_worlds(const RunOptions& options);

}  // namespace meniscus::cli
