// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What yarns leave of a sheet's edges: its diagonals, which lie in chains that zigzag.
#pragma once

#include <cstddef>

#include "cloth/build_constraints.h"
#include "cloth/coloured.h"

namespace meniscus::cloth {

/// Takes all edges out of the constraints where no vertex has more than two of them, and gives them two
/// colours, or three where a ring needs one more: a launch for each is then less than passes of clusters.
/// Else there are none, and the constraints stay as they are.
Coloured<EdgeConstraint> take_chains(ClothConstraints& constraints, size_t vertices);

}  // namespace meniscus::cloth
