// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command `meniscus schema`.
#pragma once

namespace meniscus::cli {

/// Prints the JSON Schema of scene files.
int print_schema();

}  // namespace meniscus::cli
