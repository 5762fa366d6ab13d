// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Scripts by which shells complete the command line.
#pragma once

#include <string>

#include "sdk/cli/usage/usage.h"

namespace meniscus::cli {

/// Each script completes commands, options and their values. Names of samples come from `meniscus samples`
/// at the time of completion.
std::string bash_completion(const Usage& usage);
std::string zsh_completion(const Usage& usage);
std::string fish_completion(const Usage& usage);

/// In single quotes, as each of the three shells reads it.
std::string shell_quoted(const std::string& text);

/// The words with a space between them.
std::string spaced(const std::vector<std::string>& words);

}  // namespace meniscus::cli
