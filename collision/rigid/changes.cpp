// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Changes of solids that are there: the pose of a fixed one, filters, and surfaces.
#include <cmath>
#include <utility>

#include "collision/rigid/rigid_impl.h"

namespace meniscus::collision {

btRigidBody& RigidWorld::Impl::bullet_of(const RigidRef& solid) const {
  return solid.is_body ? *body(solid.number).bullet : *fixed.slots[solid.number]->bullet;
}

/// Also where bodies sleep beside a solid without a contact.
void RigidWorld::Impl::wake_near(btRigidBody& changed) {
  btRigidBody* const body = &changed;
  wake_around({&body, 1});
  const btBroadphaseProxy* proxy = changed.getBroadphaseHandle();
  const btBroadphasePairArray& found = pairs.getOverlappingPairArray();
  for (int i = 0; i < found.size(); ++i) {
    const btBroadphasePair& pair = found[i];
    if (pair.m_pProxy0 != proxy && pair.m_pProxy1 != proxy) continue;
    const btBroadphaseProxy* other = pair.m_pProxy0 == proxy ? pair.m_pProxy1 : pair.m_pProxy0;
    static_cast<btCollisionObject*>(other->m_clientObject)->activate();
  }
  if (def.on_device) wake_overlapping(changed);
  if (!changed.isStaticObject()) wake_up(changed);
  knows_touches = false;
  parts_changed = true;
}

void RigidWorld::set_fixed_pose(uint32_t number, const Pose& pose) {
  const InBullet bullet(*reserve_, impl_->size());
  RigidFixedRecord& solid = *impl_->fixed.slots[number];
  impl_->wake_near(*solid.bullet);
  solid.bullet->setWorldTransform(to_bullet(pose) * to_bullet(solid.shape.frame));
  solid.bullet->setInterpolationWorldTransform(solid.bullet->getWorldTransform());
  impl_->dynamics.updateSingleAabb(solid.bullet.get());  // so that queries find it there
  impl_->wake_near(*solid.bullet);
}

/// Its proxy is made again, in the same place: only then does Bullet look for pairs.
void RigidWorld::set_filter(const RigidRef& solid, const CollisionFilter& filter) {
  const InBullet bullet(*reserve_, impl_->size());
  btRigidBody& changed = impl_->bullet_of(solid);
  impl_->wake_near(changed);
  changed.getBroadphaseHandle()->m_collisionFilterGroup = static_cast<int>(filter.groups);
  changed.getBroadphaseHandle()->m_collisionFilterMask = static_cast<int>(filter.mask);
  impl_->dynamics.refreshBroadphaseProxy(&changed);
  impl_->dynamics.updateSingleAabb(&changed);
  impl_->dispatcher.note_disorder();
  impl_->wake_near(changed);
}

/// Contacts that are there have the product of the old coefficients.
void RigidWorld::set_surface(const RigidRef& solid, float friction, float restitution) {
  const InBullet bullet(*reserve_, impl_->size());
  btRigidBody& changed = impl_->bullet_of(solid);
  impl_->wake_near(changed);
  changed.setFriction(std::sqrt(friction));
  changed.setRestitution(std::sqrt(restitution));
  for (int i = 0; i < impl_->dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold& manifold = *impl_->dispatcher.getManifoldByIndexInternal(i);
    const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
    if (a != &changed && b != &changed) continue;
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      btManifoldPoint& point = manifold.getContactPoint(k);
      point.m_combinedFriction = btManifoldResult::calculateCombinedFriction(a, b);
      point.m_combinedRestitution = btManifoldResult::calculateCombinedRestitution(a, b);
    }
  }
}

void RigidWorld::swap(RigidWorld& other) noexcept {
  std::swap(reserve_, other.reserve_);
  std::swap(impl_, other.impl_);
  std::swap(impl_->contacts, other.impl_->contacts);  // stays
  impl_->parts_changed = other.impl_->parts_changed = true;
}

}  // namespace meniscus::collision
