// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Chains: edges in a row, as straight as the mesh has them, whose lengths are solved for all at once. Pull
// goes from one end to the other in one go, where constraint by constraint it goes a few edges a sweep.
#pragma once

#include <span>
#include <vector>

#include "cloth/build/build_constraints.h"
#include "cloth/build/piece.h"

namespace meniscus::cloth {

/// edges[first] to edges[first + count − 1], each of which begins where the one before ends.
struct Chain {
  uint32_t first, count;

  static constexpr uint32_t fewest_edges = 4, most_edges = 512;
};

/// Chains of a layer share no vertex: they are solved at once. The longest come first, and those of like
/// length side by side.
struct Chains {
  std::vector<EdgeConstraint> edges;
  std::vector<Chain> chains;
  std::vector<uint32_t> layer_starts{0};  ///< one more than layers

  uint32_t layers() const { return static_cast<uint32_t>(layer_starts.size() - 1); }
};

/// Draws chains along the stiff edges, and takes those out of the constraints. Of a sheet all warp and all
/// weft become chains, in two layers. In a mesh without a grain, most of whose edges are softer by shear,
/// none is left to hold what lies across the stiff ones: chains run along any edge there, in three
/// directions, and leave some over. What is blown up has none: gas pushes out what chains pull in, and each
/// would undo all that the other has done, where a sweep gives way. Nor has what may tear: whole chains would
/// pull at the few vertices that bound a tear. `rest`: m, where vertices are at rest.
Chains draw_chains(ClothConstraints& constraints, std::span<const Vec3> rest, std::span<const Piece> pieces);

}  // namespace meniscus::cloth
