// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Lets a test use more threads than there are cores.
#pragma once

#include <tbb/global_control.h>

namespace meniscus::tests {

/// While it lives, oneTBB starts as many threads as a device asks for, even where there are fewer cores.
class ManyThreads {
 private:
  tbb::global_control control_{tbb::global_control::max_allowed_parallelism, 8};
};

}  // namespace meniscus::tests
