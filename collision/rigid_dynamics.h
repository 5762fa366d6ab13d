// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bullet's dispatcher and world, with what history leaves in them taken out: pairs and contacts are visited
// in an order that follows from the set of pairs alone.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/rigid_bullet.h"
#include "collision/rigid_plane.h"

namespace meniscus::collision {

class RigidDispatcher final : public btCollisionDispatcher {
 public:
  RigidDispatcher(btCollisionConfiguration* configuration, btOverlappingPairCache* pairs);

  bool needsCollision(const btCollisionObject* a, const btCollisionObject* b) override;
  void dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                 btDispatcher* self) override;

  /// Puts the manifolds into the order of their pairs, and what belongs to no pair behind them.
  void order_manifolds();
  /// The manifolds of pairs that have contacts, in their order. Most have none, as boxes around bodies are
  /// wide.
  const std::vector<btPersistentManifold*>& touching() const { return touching_; }
  /// While true, sleepers collide too.
  void set_every_pair(bool every_pair) { every_pair_ = every_pair; }

 private:
  void order_pairs();
  void follow_order();

  struct PairPlace {
    uint64_t key;  ///< the two ids
    int index;
  };
  btOverlappingPairCache* pairs_;
  RigidPlaneContacts plane_second_{false}, plane_first_{true};
  std::vector<PairPlace> order_;
  std::vector<btPersistentManifold*> touching_;
  btManifoldArray ordered_, of_pair_;
  bool every_pair_ = false;
};

class RigidDynamics final : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

  // One step of Bullet, in two. Forces are the caller's to set and to clear.

  /// Finds who touches whom where bodies are. Velocities do not count.
  void detect(float dt);
  /// Solves what was found, and moves.
  void advance(float dt);

  /// Of a body, by its number, when contacts were last looked for.
  std::vector<btTransform> detected;
  /// Those of fast bodies with what they are about to hit. They live until the next step.
  btAlignedObjectArray<btPersistentManifold*>& predictive() { return m_predictiveManifolds; }
  void release_predictive() { releasePredictiveContacts(); }

  /// Calls visit(manifold) for all that have contacts, in a fixed order.
  template <class Visit>
  void for_each_touching(const Visit& visit) {
    for (btPersistentManifold* m : static_cast<RigidDispatcher*>(getDispatcher())->touching()) visit(*m);
    for (int i = 0; i < m_predictiveManifolds.size(); ++i) visit(*m_predictiveManifolds[i]);
  }

 private:
  void prepare_contacts();
};

}  // namespace meniscus::collision
