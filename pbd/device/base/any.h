// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "pbd/device/base/qualifiers.h"

namespace meniscus::pbd {

/// Whether any test returns true. A CPU stops at the first one that does; a GPU runs all of them, as branches
/// would make what each loads wait for the one before.
template <class... Tests>
MENISCUS_HD bool any_is_true(const Tests&... tests) {
#ifdef __CUDA_ARCH__
  return (tests() | ...);
#else
  return (tests() || ...);
#endif
}

}  // namespace meniscus::pbd
