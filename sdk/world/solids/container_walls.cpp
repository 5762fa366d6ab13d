// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes boxes from the faces of a container.
#include "sdk/world/solids/container_walls.h"

#include "pbd/math/vec.h"
#include "sdk/world/solids/container_faces.h"

namespace meniscus {

std::vector<collision::RigidPart> container_walls(const ContainerGeometry& container) {
  float Vec3::*const axes[] = {&Vec3::x, &Vec3::y, &Vec3::z};
  const float thickness = max_component(container.half_extents);
  std::vector<collision::RigidPart> parts;
  // Walls extend past the corners, so that there is no gap.
  for (const FacePiece& piece : container_faces(container, thickness)) {
    const int face = static_cast<int>(piece.face);
    float Vec3::*const normal = axes[face / 2];
    collision::RigidPart part;
    part.pose.position = 0.5f * (piece.lower + piece.upper);
    part.pose.position.*normal += (face % 2 ? 0.5f : -0.5f) * thickness;
    part.size = 0.5f * (piece.upper - piece.lower);
    part.size.*normal = 0.5f * thickness;
    parts.push_back(part);
  }
  return parts;
}

}  // namespace meniscus
