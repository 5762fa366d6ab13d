// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's calls by the names that recordings have for them.
#pragma once

#include <meniscus/world.h>

#include <map>
#include <string>

#include "sdk/world/recording/call_text.h"
#include "sdk/world/recording/record_file.h"

namespace meniscus {

/// Makes a call with its arguments, which follow the name in the array. Throws what the call throws, and
/// Error(io) if the arguments do not fit.
using ReplayedCall = void (*)(World& world, const call_text::Json& call, const call_text::Ids& ids);

/// All but step.
const std::map<std::string, ReplayedCall>& replayed_calls();

bool is_step(const Record& record);
/// Whether it may create, destroy or define something in a world. A state and a step do not.
bool changes_definitions(const Record& record);

}  // namespace meniscus
