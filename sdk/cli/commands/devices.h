// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command `meniscus devices`.
#pragma once

#include "sdk/cli/commands/scene_lookup.h"

namespace meniscus::cli {

/// Prints the devices as a table or as JSON, and which of them `auto` chooses and why.
int show_devices(bool json);

/// Prints the memory that a scene takes on its device before its first step, by purpose. Throws Error if the
/// scene is not valid, and Error(out_of_memory) if memory is short.
int show_memory(const SceneChoice& choice, bool json);

}  // namespace meniscus::cli
