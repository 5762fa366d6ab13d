// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bullet's dispatcher and world without dependence on history. Pairs and contacts are visited in an order
// that follows from the set of pairs alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "collision/rigid/bullet.h"
#include "collision/rigid/plane.h"

namespace meniscus::collision {

/// Prefetches objects that are read soon. Bullet's objects are many and scattered in memory.
template <class T>
void fetch_soon(const T* objects, size_t count = 1) {
  for (size_t at = 0; at < count * sizeof(T); at += 64)
    __builtin_prefetch(reinterpret_cast<const char*>(objects) + at);
}

class RigidDispatcher final : public btCollisionDispatcher {
 public:
  RigidDispatcher(btCollisionConfiguration* configuration, btOverlappingPairCache* pairs);

  bool needsCollision(const btCollisionObject* a, const btCollisionObject* b) override;
  void dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                 btDispatcher* self) override;
  void releaseManifold(btPersistentManifold* manifold) override;

  /// Has the manifolds ordered before they are next visited.
  void note_disorder() { in_order_ = false; }
  /// Orders the manifolds by their pairs. Manifolds of no pair come last.
  void order_manifolds();
  /// Calls visit(manifold, pair) for the pairs that have contacts, in their order. Most pairs have none,
  /// because the boxes around bodies are wide.
  template <class Visit>
  void for_each_touching(const Visit& visit) {
    constexpr size_t ahead = 4;
    if (!in_order_) order_manifolds();
    for (size_t k = 0; k < touching_.size(); ++k) {
      if (k + ahead < touching_.size()) {
        const Touching& next = touching_[k + ahead];
        fetch_soon(next.first_point, next.points);
        fetch_soon(&next.manifold->m_companionIdA);  // beside the number of points
      }
      visit(*touching_[k].manifold, touching_[k].pair);
    }
  }
  /// While true, pairs of sleeping bodies collide too.
  void set_every_pair(bool every_pair) { every_pair_ = every_pair; }

 private:
  void order_pairs();
  void follow_order();

  struct PairPlace {
    uint64_t key;  ///< the two ids
    int index;
  };
  struct Touching {
    btPersistentManifold* manifold;
    const btManifoldPoint* first_point;
    uint32_t points;
    uint64_t pair;  ///< the two ids
  };
  btOverlappingPairCache* pairs_;
  RigidPlaneContacts plane_second_{false}, plane_first_{true};
  std::vector<PairPlace> order_;
  std::vector<Touching> touching_;
  btManifoldArray ordered_, of_pair_;
  bool every_pair_ = false;
  bool in_order_ = true;
};

class RigidDynamics final : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

  // One step of Bullet, in two parts. The caller sets and clears forces.

  /// Finds contacts at the bodies' current poses. Velocities have no effect.
  void detect(float dt);
  /// Solves the contacts that were found, and moves the bodies.
  void advance(float dt);

  /// Removes solids that the broadphase no longer has, as removeRigidBody() of each would in this order.
  /// Takes memory before it changes anything.
  void remove_all(std::span<btRigidBody* const> gone);
  /// Leaves out all solids and joints, without the work of removals. The broadphase then only ends.
  void forget_all();
  /// A joint knows its place among the joints, so that its removal needs no search.
  void add_joint(btTypedConstraint& joint);
  void remove_joint(btTypedConstraint& joint);

  /// By body: its pose when contacts were last searched.
  std::vector<btTransform> detected;
  /// The contacts of fast bodies with what they are about to hit. They live until the next step.
  btAlignedObjectArray<btPersistentManifold*>& predictive() { return m_predictiveManifolds; }
  void release_predictive() { releasePredictiveContacts(); }

  /// Calls visit(manifold) for all manifolds that have contacts, in a fixed order.
  template <class Visit>
  void for_each_touching(const Visit& visit) {
    static_cast<RigidDispatcher*>(getDispatcher())
        ->for_each_touching([&](btPersistentManifold& manifold, uint64_t) { visit(manifold); });
    for (int i = 0; i < m_predictiveManifolds.size(); ++i) visit(*m_predictiveManifolds[i]);
  }

  template <class Visit>
  void for_each_object(const Visit& visit) const {
    for (int i = 0; i < m_collisionObjects.size(); ++i) visit(*m_collisionObjects[i]);
  }
  template <class Visit>
  void for_each_moving(const Visit& visit) const {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) visit(*m_nonStaticRigidBodies[i]);
  }
  // Put Bullet's lists, which have just these elements, in this order.
  void order_objects(const std::vector<btRigidBody*>& objects);
  void order_moving(const std::vector<btRigidBody*>& bodies);
  void order_joints(const std::vector<btTypedConstraint*>& joints);

 private:
  void prepare_contacts();
};

}  // namespace meniscus::collision
