// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads how a rigid world stands in Bullet's lists, and makes another stand like that.
#include "collision/rigid/rigid_layout.h"

#include <meniscus/error.h>

#include "collision/rigid/rigid_impl.h"

namespace meniscus::collision {

namespace {

[[noreturn]] void refuse() {
  throw Error(ErrorCode::io, "the order of solids and joints does not fit their definitions");
}

/// The object of each number in `order`. Each object must be there once.
template <class T, class Find>
std::vector<T*> in_order(std::span<const uint32_t> order, size_t count, const Find& find) {
  std::vector<T*> objects;
  std::vector<uint32_t> sorted(order.begin(), order.end());
  std::ranges::sort(sorted);
  if (order.size() != count || std::ranges::adjacent_find(sorted) != sorted.end()) refuse();
  for (const uint32_t code : order) {
    objects.push_back(find(code));
    if (!objects.back()) refuse();
  }
  return objects;
}

}  // namespace

RigidLayout RigidWorld::layout() const {
  RigidLayout layout;
  impl_->dynamics.for_each_object([&](const btCollisionObject& object) {
    const RigidRef solid = impl_->solid_of(&object);
    layout.objects.push_back(2 * solid.number + solid.is_body);
    layout.proxies.push_back(static_cast<uint32_t>(object.getBroadphaseHandle()->m_uniqueId));
  });
  impl_->dynamics.for_each_moving(
      [&](const btRigidBody& body) { layout.moving.push_back(static_cast<uint32_t>(body.getUserIndex())); });
  for (int i = 0; i < impl_->dynamics.getNumConstraints(); ++i) {
    for (uint32_t n = 0; n < impl_->joints.slots.size(); ++n) {
      if (!has_joint(n) || impl_->joints.slots[n]->bullet.get() != impl_->dynamics.getConstraint(i)) continue;
      layout.joints.push_back(n);
      layout.joint_places.push_back(impl_->joints.slots[n]->places);
    }
  }
  layout.proxy_room = impl_->broadphase.room();
  return layout;
}

void RigidWorld::arrange(const RigidLayout& layout) {
  const InBullet bullet(*reserve_, impl_->size());
  const auto find_solid = [&](uint32_t code) { return impl_->object(code); };
  const auto find_joint = [&](uint32_t n) -> btTypedConstraint* {
    return has_joint(n) ? impl_->joints.slots[n]->bullet.get() : nullptr;
  };
  RigidDynamics& dynamics = impl_->dynamics;
  const auto solids = static_cast<size_t>(dynamics.getNumCollisionObjects());
  dynamics.order_objects(in_order<btRigidBody>(layout.objects, solids, find_solid));
  dynamics.order_moving(
      in_order<btRigidBody>(layout.moving, body_count(), [&](uint32_t n) { return find_solid(2 * n + 1); }));
  dynamics.order_joints(in_order<btTypedConstraint>(
      layout.joints, static_cast<size_t>(dynamics.getNumConstraints()), find_joint));
  impl_->broadphase.make_room(layout.proxy_room);
}

}  // namespace meniscus::collision
