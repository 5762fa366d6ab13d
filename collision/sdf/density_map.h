// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Density maps (Koschier & Bender 2017; Bender et al. 2020, volume maps): how much of a particle's kernel a
// solid fills, B(x) = ∫ W_poly6(|x − y|, h) dy over the solid, and ∇B, beside the distance at each node of
// its field. B is 1 deep inside, ½ on a flat face, 0 from h on.
#pragma once

#include <vector>

#include "collision/sdf/build.h"

namespace meniscus::collision {

/// Fills the density map of the mesh's field for the support radius h (m). The field's margin must be at
/// least h; its cells should not exceed h/4. The solid is as the field has it, and, up to 16 million
/// nodes, finer than its cells where the mesh is near. Throws Error(invalid_argument) where h is not positive
/// and finite. With cells of h/4, sample_density is off by .003 on flat faces, .01 at edges, in corners, and
/// on plates of two cells; ∇B by .12/h, a tenth of what it is on a flat face at most, since it is linear
/// between nodes. With cells of h/8: .002, .007 and .07/h.
template <class D>
void build_density_map(D& device, const DeviceTriangleBvh& mesh, Sdf& sdf, float h);

}  // namespace meniscus::collision
