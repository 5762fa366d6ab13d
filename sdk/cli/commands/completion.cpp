// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus completion`.
#include "sdk/cli/commands/completion.h"

#include <spdlog/fmt/fmt.h>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/usage/completion.h"

namespace meniscus::cli {

int print_completion(const Usage& usage, const std::string& shell) {
  fmt::print("{}", shell == "bash"  ? bash_completion(usage)
                   : shell == "zsh" ? zsh_completion(usage)
                                    : fish_completion(usage));
  return success;
}

}  // namespace meniscus::cli
