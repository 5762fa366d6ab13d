// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command-line program as a function that tests can call.
#pragma once

#include "sdk/cli/commands/exit_code.h"

namespace meniscus::cli {

/// Parses the command line and runs the command. Errors become one line on stderr and an exit code.
int run_program(int argc, char** argv);

}  // namespace meniscus::cli
