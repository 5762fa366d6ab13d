// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The options of commands that compare: with other methods, with experiment and with a paper.
#pragma once

#include "sdk/cli/commands/compare.h"
#include "sdk/cli/commands/validate.h"
#include "sdk/cli/reproduce/reproduce.h"
#include "sdk/cli/shared_options.h"

namespace meniscus::cli {

void add_compare(CLI::App& app, CompareOptions& options, Command& command);
void add_validate(CLI::App& app, ValidateOptions& options, Command& command);
void add_reproduce(CLI::App& app, ReproduceOptions& options, Command& command);

}  // namespace meniscus::cli
