// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What Python knows of a world that comes from elsewhere: from a file, a clone or a recording.
#pragma once

#include <string>

#include "sdk/python/state/world_state.h"

namespace meniscus::python {

/// What exists in a world with these definitions, which are those of a snapshot file.
Things things_of(const World& w, const std::string& definitions);
/// The same things with the ids of a clone.
Things things_of(const World& clone, Things all);
/// What exists in a world of which nothing is known: its definitions are read from a passing file.
Things saved_things(const World& w);

}  // namespace meniscus::python
