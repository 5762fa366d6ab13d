// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ranks that are threads of one process.
#pragma once

#include <memory>
#include <vector>

#include "pbd/ranks/ranks.h"

namespace meniscus::tests {

/// Makes `count` ranks of one world, each for a thread of its own. They may be destroyed in any order.
std::vector<std::unique_ptr<pbd::Ranks>> make_thread_ranks(int count);

}  // namespace meniscus::tests
