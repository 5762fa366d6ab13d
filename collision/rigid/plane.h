// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts of convex shapes with planes. Bullet's own algorithm finds one point in a step, so a sliding body
// has fewer contacts than a resting one. Here all corners are tested in each step.
#pragma once

#include "collision/rigid/bullet.h"

namespace meniscus::collision {

/// Creates the algorithm for pairs in which the plane is second, or first with `plane_first`.
class RigidPlaneContacts final : public btCollisionAlgorithmCreateFunc {
 public:
  explicit RigidPlaneContacts(bool plane_first) { m_swapped = plane_first; }
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* a,
                                                 const btCollisionObjectWrapper* b) override;
};

}  // namespace meniscus::collision
