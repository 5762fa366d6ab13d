// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Meshes of the round pieces of cloth; see ClothGeometry. Their triangles face outwards.
#pragma once

#include <meniscus/cloth.h>

#include "cloth/build/cloth_mesh.h"

namespace meniscus {

/// The arguments must have passed check::def.
cloth::ClothMesh sphere_mesh(const ClothSphere& sphere);
cloth::ClothMesh tube_mesh(const ClothTube& tube);

}  // namespace meniscus
