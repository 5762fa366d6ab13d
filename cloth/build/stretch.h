// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraints of stretch and shear, of edges or of triangles.
#pragma once

#include <vector>

#include "cloth/build/build_constraints.h"
#include "cloth/build/rest_geometry.h"
#include "cloth/build/topology.h"

namespace meniscus::cloth {

/// An edge at an angle φ to the warp has the energy ½ k(φ) A ε². A is the area of its triangles. With c = cos
/// φ and s = sin φ,
///
///   1/k = c⁴/k_warp + s⁴/k_weft + c² s²/k_shear.
///
/// This is the modulus of an orthotropic sheet in that direction (Jones, Mechanics of Composite Materials,
/// ch. 2, without Poisson's ratio). Edges with unlimited compliance are left out.
std::vector<EdgeConstraint> stretch_of_edges(const ClothMesh& mesh, std::span<const EdgeUse> uses,
                                             const std::vector<TriangleAtRest>& triangles,
                                             const FabricParameters& fabric);

/// 1/k(φ) of the above, m/N, from cos² φ: the strain of a strip of the fabric in that direction per force per
/// width. 0 where the fabric is unyielding, infinity where it does not resist.
double yield_along(double cos2, const FabricParameters& fabric);

/// The greatest compliance that a float in a kernel can still divide by the square of a substep.
inline constexpr double most_compliance = 1e20;

/// The energy of a triangle is ½ A (k_warp C_u² + k_weft C_v² + k_shear C_uv²).
std::vector<StrainConstraint> strain_of_triangles(const ClothMesh& mesh,
                                                  const std::vector<TriangleAtRest>& triangles,
                                                  const FabricParameters& fabric);

}  // namespace meniscus::cloth
