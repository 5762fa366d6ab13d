// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bending, a hinge an inner edge.
#pragma once

#include <vector>

#include "cloth/build/build_constraints.h"
#include "cloth/build/rest_geometry.h"
#include "cloth/build/topology.h"

namespace meniscus::cloth {

struct Hinges {
  std::vector<HingeConstraint> dihedral;
  std::vector<IsometricConstraint> isometric;
};

/// A hinge of length l between triangles of areas A₁ and A₂ has the energy ½ D l²/(A₁ + A₂) (θ − θ₀)²: on a
/// grid that is bent along an axis, and on equilateral triangles bent in any direction, that is ½ D κ² an
/// area. (The hinges of Grinspun et al. 2003 weigh 3 times as much.) Isometric hinges, with 2 sin(θ/2) for θ
/// in the same energy, are for what is flat at rest; the others stay dihedral.
Hinges bending_of_edges(const ClothMesh& mesh, std::span<const EdgeUse> uses,
                        const std::vector<TriangleAtRest>& triangles, const FabricParameters& fabric);

}  // namespace meniscus::cloth
