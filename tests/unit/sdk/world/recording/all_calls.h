// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A run that makes each call of World that changes it.
#pragma once

#include <meniscus/meniscus.h>

namespace meniscus::tests {

/// A world with something of each kind, some of them as defaults.
World make_for_all_calls(const WorldDef& def);
/// Makes each call at least once, with steps in between.
void make_all_calls(World& world);

}  // namespace meniscus::tests
