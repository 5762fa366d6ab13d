// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A disjunction that branches on a CPU and evaluates all terms on a GPU.
#pragma once

#include "pbd/device/base/qualifiers.h"

namespace meniscus::pbd {

/// Whether any test returns true. A CPU stops at the first such test. A GPU runs all of them, because
/// branches would serialise their loads.
template <class... Tests>
MENISCUS_HD bool any_is_true(const Tests&... tests) {
#ifdef __CUDA_ARCH__
  return (tests() | ...);
#else
  return (tests() || ...);
#endif
}

}  // namespace meniscus::pbd
