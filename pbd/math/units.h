// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Numbers as integers, which have the same sum in any order.
#pragma once

#include "pbd/math/vec.h"

namespace meniscus::pbd {

/// x, a number of units, as an integer. Numbers beyond ±2⁵² count as that, so a sum of 1,024 does not
/// overflow.
MENISCUS_HD inline int64_t whole_units(float x) {
  return llrintf(clamp(x, -0x1p52f, 0x1p52f));
}

}  // namespace meniscus::pbd
