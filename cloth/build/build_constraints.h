// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds the constraints of the solver from a mesh and the stiffnesses of a fabric.
#pragma once

#include <limits>
#include <vector>

#include "cloth/build/cloth_mesh.h"
#include "cloth/build/coloured.h"
#include "cloth/build/constraints.h"

namespace meniscus::cloth {

inline constexpr float unyielding = std::numeric_limits<float>::infinity();

/// The density and stiffnesses of a fabric. Stiffnesses are per width of cloth, as tests of fabric give them:
/// 0 is none, infinity is unyielding.
struct FabricParameters {
  float density = 0.2f;  ///< kg/m²

  float warp_stiffness = unyielding;   ///< N/m: tension over strain, along u
  float weft_stiffness = unyielding;   ///< N/m: along v
  float shear_stiffness = unyielding;  ///< N/m: shear force per width over the shear angle
  float bending_stiffness = 0;         ///< N·m: moment per width over curvature

  bool strain_triangles = false;  ///< stretch and shear by triangles, else by edges
  bool dihedral = false;  ///< bending by the angle between triangles, else isometric where flat at rest
};

struct ClothConstraints {
  std::vector<float> masses;  ///< kg, of each vertex: a third of each of its triangles
  Coloured<EdgeConstraint> edges;
  Coloured<StrainConstraint> strains;
  Coloured<HingeConstraint> hinges;
  std::vector<IsometricConstraint> isometric;  ///< solved as one block, so they need no colours
};

/// The constraints of a mesh that check_mesh accepts. Within a colour they are in the order of their lowest
/// vertex. The parameters must be in the ranges of FabricDef, which World checks.
ClothConstraints build_constraints(const ClothMesh& mesh, const FabricParameters& fabric);

}  // namespace meniscus::cloth
