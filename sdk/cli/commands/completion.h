// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command `meniscus completion`.
#pragma once

#include <string>

#include "sdk/cli/usage/usage.h"

namespace meniscus::cli {

/// Prints the script by which a shell, bash, zsh or fish, completes the command line.
int print_completion(const Usage& usage, const std::string& shell);

}  // namespace meniscus::cli
