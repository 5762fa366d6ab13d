// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How the contents of a rigid world stand in Bullet's lists.
#pragma once

#include <vector>

#include "pbd/contacts.h"
#include "pbd/state/state_visitor.h"

namespace meniscus::collision {

/// Where a solid is to stand. Left out, it takes the lowest free number and any free proxy.
struct RigidPlace {
  uint32_t number = pbd::no_index;
  uint32_t proxy = pbd::no_index;  ///< of the broad phase
};

/// Poses of a joint's two bodies when it was made: basis and origin, row by row. Its frames follow from
/// these.
struct JointPlaces {
  float a[12], b[12];
};

/// The order of Bullet's lists, on which the order of its sums depends. A world with the same definitions in
/// the same order continues bit for bit.
struct RigidLayout {
  std::vector<uint32_t> objects;  ///< all solids: 2 · number of a fixed one, 2 · number + 1 of a body
  std::vector<uint32_t> proxies;  ///< of each of these
  std::vector<uint32_t> moving;   ///< the numbers of bodies
  std::vector<uint32_t> joints;   ///< the numbers of joints
  std::vector<JointPlaces> joint_places;  ///< of each of these
  uint32_t proxy_room = 0;

  void visit_state(pbd::StateVisitor& v) {
    v.list("object", objects);
    v.list("proxy", proxies);
    v.list("moving", moving);
    v.list("joint", joints);
    v.list("joint_places", joint_places);
    v.value("proxy_room", proxy_room);
  }
};

}  // namespace meniscus::collision
