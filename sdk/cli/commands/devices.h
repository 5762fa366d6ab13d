// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

namespace meniscus::cli {

/// Prints the devices as a table, and which of them `auto` takes and why.
int show_devices();

}  // namespace meniscus::cli
