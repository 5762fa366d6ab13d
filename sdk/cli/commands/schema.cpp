// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus schema`.
#include "sdk/cli/commands/schema.h"

#include <spdlog/fmt/fmt.h>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/scene/scene_file.h"

namespace meniscus::cli {

int print_schema() {
  fmt::print("{}", scene_schema());
  return success;
}

}  // namespace meniscus::cli
