// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bending: one hinge for each inner edge.
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

/// A hinge of length l between triangles of areas A₁ and A₂ has the energy ½ D l²/(A₁ + A₂) (θ − θ₀)². On a
/// grid bent along an axis, and on equilateral triangles bent in any direction, that is ½ D κ² per area. The
/// hinges of Grinspun et al. 2003 weigh 3 times as much. Hinges that are flat at rest are isometric, with 2
/// sin(θ/2) for θ in the same energy. The others are dihedral.
Hinges bending_of_edges(const ClothMesh& mesh, std::span<const EdgeUse> uses,
                        const std::vector<TriangleAtRest>& triangles, const FabricParameters& fabric);

}  // namespace meniscus::cloth
