// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bullet's shapes for the parts of a solid.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "collision/rigid/bullet.h"
#include "collision/rigid/rigid_world.h"

namespace meniscus::collision {

/// Bullet's shape of a solid, with the data that it refers to.
struct RigidShape {
  btCollisionShape* root = nullptr;
  Pose frame;         ///< the root's frame in the geometry's frame; the frame of the mass, if there is one
  btVector3 inertia;  ///< about the frame's axes, kg m²
  float radius = 0;   ///< m, of the bounding ball around the frame's origin
  float inner_radius = 0;  ///< m, of a ball that fits inside; fast bodies are swept with it
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<std::unique_ptr<btStridingMeshInterface>> meshes;
  std::vector<std::shared_ptr<const void>> data;
};

/// Throws Error(invalid_argument) for a hull whose points span no volume.
RigidShape make_rigid_shape(std::span<const RigidPart> parts, const MassProperties* mass);

}  // namespace meniscus::collision
