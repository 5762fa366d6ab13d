// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Whether two collision filters let their owners collide.
#pragma once

#include <meniscus/types.h>

#include "pbd/device/base/qualifiers.h"

namespace meniscus::pbd {

/// Whether each filter accepts the other.
MENISCUS_HD inline bool meet(const CollisionFilter& a, const CollisionFilter& b) {
  return (a.groups & b.mask) != 0 && (b.groups & a.mask) != 0;
}

}  // namespace meniscus::pbd
