// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Snapshots of the state. Bullet's collision algorithms cannot be copied, so they are made again. Bodies are
// placed where they were when contacts were last searched, and every pair is processed again. That gives the
// same manifolds in the same order. Their contents are then overwritten with the saved ones.
#include <algorithm>
#include <cassert>

#include "collision/rigid/rigid_snapshot.h"

namespace meniscus::collision {

namespace {

SavedBody saved(const RigidBodyRecord& body, const btTransform& detected) {
  const btRigidBody& b = *body.bullet;
  return {b.getWorldTransform(),
          b.getInterpolationWorldTransform(),
          detected,
          b.getLinearVelocity(),
          b.getAngularVelocity(),
          b.getInterpolationLinearVelocity(),
          b.getInterpolationAngularVelocity(),
          b.getDeactivationTime(),
          b.getActivationState(),
          body.memory};
}

void put_back(RigidBodyRecord& body, const SavedBody& saved) {
  btRigidBody& b = *body.bullet;
  b.setWorldTransform(saved.pose);
  b.updateInertiaTensor();
  b.setInterpolationWorldTransform(saved.interpolated);
  b.setLinearVelocity(saved.velocity);
  b.setAngularVelocity(saved.angular_velocity);
  b.setInterpolationLinearVelocity(saved.interpolated_velocity);
  b.setInterpolationAngularVelocity(saved.interpolated_angular_velocity);
  b.setDeactivationTime(saved.idle_time);
  b.forceActivationState(saved.activation);
  body.memory = saved.memory;
}

}  // namespace

void RigidWorld::DeleteSnapshot::operator()(Snapshot* snapshot) const {
  delete snapshot;
}

RigidWorld::SnapshotPtr RigidWorld::make_snapshot() {
  return SnapshotPtr(new Snapshot);
}

void RigidWorld::save_bodies(Snapshot& to) const {
  to.bodies.clear();
  impl_->for_each_body([&](uint32_t n, const RigidBodyRecord& body) {
    to.bodies.push_back(saved(body, impl_->dynamics.detected[n]));
  });
  to.time = impl_->time;
}

void RigidWorld::save_in_bullet(Snapshot& to) const {
  const InBullet bullet(*reserve_, impl_->size());
  to.pairs.clear();
  const btBroadphasePairArray& pairs = impl_->pairs.getOverlappingPairArray();
  for (int i = 0; i < pairs.size(); ++i) {
    to.pairs.push_back(
        {pairs[i].m_pProxy0->m_uniqueId, pairs[i].m_pProxy1->m_uniqueId, pairs[i].m_algorithm != nullptr});
  }
  to.manifolds.clear();
  to.points.clear();
  auto& predictive = impl_->dynamics.predictive();
  impl_->dispatcher.for_each_touching([&](const btPersistentManifold& manifold, uint64_t) {
    const int count = manifold.getNumContacts();
    to.manifolds.push_back({manifold.m_index1a, count});
    const btManifoldPoint* first = &manifold.getContactPoint(0);
    to.points.insert(to.points.end(), first, first + count);
  });
  to.predictions.clear();
  to.predicted_points.clear();
  const auto code = [&](const btCollisionObject* object) {
    const RigidRef solid = impl_->solid_of(object);
    return 2 * solid.number + solid.is_body;
  };
  for (int i = 0; i < predictive.size(); ++i) {
    const btPersistentManifold& m = *predictive[i];
    to.predictions.push_back({code(m.getBody0()), code(m.getBody1()), m.getNumContacts()});
    const btManifoldPoint* first = &m.getContactPoint(0);
    to.predicted_points.insert(to.predicted_points.end(), first, first + m.getNumContacts());
  }
  impl_->broadphase.save(to.broadphase);
  to.resting = impl_->resting;
}

void RigidWorld::save_contacts(Snapshot& to) const {
  save_in_bullet(to);
  to.is_kept = false;
  to.on_device.clear();
  if (!impl_->contacts) return;
  impl_->update_parts();
  to.on_device = impl_->contacts->save();
}

void RigidWorld::keep_contacts(Snapshot& to) const {
  save_in_bullet(to);
  to.is_kept = true;
  if (!impl_->contacts) return;
  impl_->update_parts();
  impl_->contacts->keep();
}

namespace {

/// Makes the pairs in their saved order, with algorithms for those that had one, and their manifolds.
void remake_pairs(const std::vector<SavedPair>& saved, btHashedOverlappingPairCache& pairs,
                  RigidBroadphase& broadphase, RigidDispatcher& dispatcher, const btDispatcherInfo& info) {
  for (const SavedPair& pair : saved) {
    pairs.addOverlappingPair(broadphase.proxy(pair.a), broadphase.proxy(pair.b));
  }
  assert(pairs.getNumOverlappingPairs() == static_cast<int>(saved.size()));
  dispatcher.set_every_pair(true);
  for (size_t i = 0; i < saved.size(); ++i) {
    if (!saved[i].has_algorithm) continue;
    (*dispatcher.getNearCallback())(pairs.getOverlappingPairArray()[static_cast<int>(i)], dispatcher, info);
  }
  dispatcher.set_every_pair(false);
  dispatcher.order_manifolds();
}

void refill(btPersistentManifold& manifold, const btManifoldPoint* points, int count) {
  manifold.setNumContacts(count);
  for (int p = 0; p < count; ++p) manifold.getContactPoint(p) = points[p];
}

void refill_all(RigidDispatcher& dispatcher, const std::vector<SavedManifold>& saved,
                const btManifoldPoint* points) {
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    dispatcher.getManifoldByIndexInternal(i)->setNumContacts(0);
  }
  for (const SavedManifold& manifold : saved) {
    assert(manifold.index < dispatcher.getNumManifolds());
    refill(*dispatcher.getManifoldByIndexInternal(manifold.index), points, manifold.points);
    points += manifold.points;
  }
  dispatcher.order_manifolds();
}

}  // namespace

void RigidWorld::restore(const Snapshot& from) {
  const InBullet bullet(*reserve_);
  RigidDynamics& dynamics = impl_->dynamics;
  dynamics.release_predictive();
  impl_->drop_pairs();
  impl_->broadphase.restore(from.broadphase);
  auto saved_body = from.bodies.begin();
  for (size_t n = 0; n < impl_->bodies.slots.size(); ++n) {
    if (!impl_->bodies.slots[n]) continue;
    assert(saved_body != from.bodies.end());
    dynamics.detected[n] = saved_body->detected;
    impl_->bodies.slots[n]->bullet->setWorldTransform((saved_body++)->detected);
  }
  remake_pairs(from.pairs, impl_->pairs, impl_->broadphase, impl_->dispatcher, dynamics.getDispatchInfo());
  refill_all(impl_->dispatcher, from.manifolds, from.points.data());
  const btManifoldPoint* predicted = from.predicted_points.data();
  for (const SavedPrediction& saved : from.predictions) {
    btPersistentManifold* made =
        impl_->dispatcher.getNewManifold(impl_->object(saved.a), impl_->object(saved.b));
    refill(*made, predicted, saved.points);
    predicted += saved.points;
    dynamics.predictive().push_back(made);
  }
  saved_body = from.bodies.begin();
  for (const auto& body : impl_->bodies.slots) {
    if (body) put_back(*body, *saved_body++);
  }
  impl_->boxes_changed = impl_->def.on_device;
  impl_->may_have_islands = true;
  if (impl_->contacts) {
    assert(!(from.is_kept && impl_->parts_changed));
    impl_->update_parts();
    if (from.is_kept)
      impl_->contacts->take_back();
    else
      impl_->contacts->restore(from.on_device);
  }
  impl_->resting = from.resting;
  impl_->time = from.time;
  impl_->knows_touches = false;
}

}  // namespace meniscus::collision
