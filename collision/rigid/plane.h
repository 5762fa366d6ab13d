// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts of convex shapes with planes. Bullet's own algorithm finds one point a step, which leaves what
// slides on less than it stands on. Here all corners are looked at in each step.
#pragma once

#include "collision/rigid/bullet.h"

namespace meniscus::collision {

/// Makes the algorithm for pairs in which the plane comes second, or with `plane_first` first.
class RigidPlaneContacts final : public btCollisionAlgorithmCreateFunc {
 public:
  explicit RigidPlaneContacts(bool plane_first) { m_swapped = plane_first; }
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* a,
                                                 const btCollisionObjectWrapper* b) override;
};

}  // namespace meniscus::collision
