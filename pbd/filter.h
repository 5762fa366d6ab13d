// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/types.h>

#include "pbd/device/base/qualifiers.h"

namespace meniscus::pbd {

/// Whether each of the two wants to meet the other.
MENISCUS_HD inline bool meet(const CollisionFilter& a, const CollisionFilter& b) {
  return (a.groups & b.mask) != 0 && (b.groups & a.mask) != 0;
}

}  // namespace meniscus::pbd
