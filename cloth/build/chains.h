// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Chains: rows of edges, as straight as the mesh has them, whose lengths are solved for all at once. One
// solve carries a pull from end to end. Single constraints carry it a few edges per sweep.
#pragma once

#include <span>
#include <vector>

#include "cloth/build/build_constraints.h"
#include "cloth/build/piece.h"
#include "cloth/build/tuning.h"

namespace meniscus::cloth {

/// edges[first] to edges[first + count − 1]. Each begins where the one before ends.
struct Chain {
  uint32_t first, count;

  static constexpr uint32_t fewest_edges = chain_tuning::fewest_edges, most_edges = 512;
};

/// Chains of a layer share no vertex, so that they can be solved at once. Longer chains come first, so that
/// chains of similar length are side by side.
struct Chains {
  std::vector<EdgeConstraint> edges;
  std::vector<Chain> chains;
  std::vector<uint32_t> layer_starts{0};  ///< one more than the number of layers

  uint32_t layers() const { return static_cast<uint32_t>(layer_starts.size() - 1); }
};

/// Selects chains along the stiff edges, and removes these from the constraints. In a sheet all warp and weft
/// edges form chains, in two layers. In a mesh without a grain most edges are softer, by their shear, so that
/// nothing would hold the directions across the stiff ones. Its chains run along any edges, in three
/// directions, and leave some edges over. Pieces with gas have no chains: gas pushes out what chains pull in,
/// and each would undo the other, where a sweep yields. Nor have pieces that may tear: whole chains would
/// pull at the few vertices around a tear. `rest`: m, the vertices at rest.
Chains draw_chains(ClothConstraints& constraints, std::span<const Vec3> rest, std::span<const Piece> pieces);

}  // namespace meniscus::cloth
