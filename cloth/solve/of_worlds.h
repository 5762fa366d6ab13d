// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraints of all worlds of a batch, from those of one (pbd/worlds.h). Each world then has the
// constraints of a world alone, in the same order. Vertices and pieces are numbered world after world.
#pragma once

#include "cloth/build/chains.h"
#include "cloth/build/cloth_model.h"
#include "cloth/build/clusters.h"

namespace meniscus::cloth {

/// Of the constraints, only masses and isometric hinges.
ClothModel of_worlds(const ClothModel& one, uint32_t worlds);
/// `vertices`: of a world. Edges are in the order of worlds. In each layer, a chain of all worlds is side by
/// side.
Chains of_worlds(const Chains& one, uint32_t vertices, uint32_t worlds);
/// Each pass, or each colour, has the worlds one after the other. Edges of clusters are in the order of
/// worlds.
Clusters of_worlds(const Clusters& one, uint32_t vertices, uint32_t worlds);
/// Where the edges of all worlds are, in the order of worlds, if they are solved by colour; otherwise empty.
/// `colour_starts`: of one world.
std::vector<uint32_t> places_by_world(const std::vector<uint32_t>& colour_starts, uint32_t worlds);

}  // namespace meniscus::cloth
