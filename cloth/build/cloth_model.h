// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The model of all cloth in a world, which the host passes to the solver.
#pragma once

#include <vector>

#include "cloth/build/build_constraints.h"
#include "cloth/build/clusters.h"
#include "cloth/build/piece.h"
#include "pbd/surface_tree/surface.h"

namespace meniscus::cloth {

struct ClothModel {
  ClothConstraints constraints;
  std::vector<Tether> tethers;  ///< in the order of their anchors
  std::vector<pbd::SurfaceTriangle> triangles;
  std::vector<Vec3> rest;
  std::vector<Piece> pieces;
  std::vector<uint32_t> held;  ///< vertices that nothing moves, ascending
};

/// CSR adjacency: the list of vertex v is items[start[v]] to items[start[v + 1] − 1].
struct Adjacency {
  std::vector<uint32_t> start, items;
};

/// The corners of triangles at each vertex: 3 · triangle + corner.
Adjacency corners_by_vertex(const std::vector<pbd::SurfaceTriangle>& triangles, size_t vertices);
/// The ends of edges at each vertex: 2 · edge + end.
Adjacency edge_ends_by_vertex(const std::vector<EdgeConstraint>& edges, size_t vertices);

/// The damping that all pieces of cloth have in common.
CommonDamping common_damping(const std::vector<Piece>& pieces);

}  // namespace meniscus::cloth
