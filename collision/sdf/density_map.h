// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Density maps (Koschier & Bender 2017; Bender et al. 2020, volume maps): the fraction of a particle's kernel
// that a solid fills. B(x) = ∫ W_poly6(|x − y|, h) dy over the solid, and ∇B, are stored beside the distance
// at each node of the field. B is 1 deep inside, ½ on a flat face, and 0 from the distance h on.
#pragma once

#include <vector>

#include "collision/sdf/build.h"
#include "collision/sdf/tuning.h"

namespace meniscus::collision {

/// Fills the density map of the mesh's field for the support radius h (m). The field's margin must be at
/// least h, and its cells should not exceed h/4. The solid is that of the field. Near the mesh it is finer
/// than the field's cells, up to `most_samples`. Throws Error(invalid_argument) where h is not positive and
/// finite.
///
/// Errors with cells of h/4: sample_density is off by 0.003 on flat faces, and by 0.01 at edges, in corners
/// and on plates of two cells. ∇B is off by 0.12/h at most, a tenth of its value on a flat face, because it
/// is linear between nodes. With cells of h/8: 0.002, 0.007 and 0.07/h.
template <class D>
void build_density_map(D& device, const DeviceTriangleBvh& mesh, Sdf& sdf, float h,
                       double most_samples = sdf_tuning::most_samples);

}  // namespace meniscus::collision
