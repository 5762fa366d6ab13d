// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/cli/commands/scene_lookup.h"

namespace meniscus::cli {

/// Prints the devices as a table, and which of them `auto` takes and why.
int show_devices();

/// Prints what memory a scene takes on its device before its first step, by what it is for. Throws Error
/// where the scene is not valid, and Error(out_of_memory) where there is not enough.
int show_memory(const SceneChoice& choice);

}  // namespace meniscus::cli
