// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The membranes that close a mesh's holes: where the sign of a field changes between two nodes and no
// triangle is near.
#pragma once

#include <span>

#include "collision/mesh/lattice.h"
#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// An edge of the lattice that a membrane crosses, from a node to the next one along an axis (0, 1, 2).
struct MembraneEdge {
  uint32_t node;
  uint32_t axis;
};

/// The edges whose ends differ in sign although the nearest triangle is too far away to pass between them.
std::vector<MembraneEdge> membrane_edges(const Lattice& lattice, std::span<const float> distances);

/// The surface through the edges' crossings, at these fractions of their length. It has a quadrilateral per
/// edge, with corners in the four cells around the edge. Each corner is at the mean of its cell's crossings
/// (surface nets, Gibson 1998).
TriangleMesh membrane_mesh(const Lattice& lattice, std::span<const MembraneEdge> edges,
                           std::span<const float> fractions);

}  // namespace meniscus::collision
