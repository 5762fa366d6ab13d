// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bullet's dispatcher and world, with what history leaves in them taken out: pairs and contacts are visited
// in an order that follows from the set of pairs alone.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/rigid/bullet.h"
#include "collision/rigid/plane.h"

namespace meniscus::collision {

/// Has objects brought near: they are read soon. Bullet's are many, and lie about in memory.
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

  /// Puts the manifolds into the order of their pairs, and what belongs to no pair behind them.
  void order_manifolds();
  /// Calls visit(manifold, pair) for those of pairs that have contacts, in their order. Most have none, as
  /// boxes around bodies are wide.
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
  /// While true, sleepers collide too.
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
    static_cast<RigidDispatcher*>(getDispatcher())
        ->for_each_touching([&](btPersistentManifold& manifold, uint64_t) { visit(manifold); });
    for (int i = 0; i < m_predictiveManifolds.size(); ++i) visit(*m_predictiveManifolds[i]);
  }

 private:
  void prepare_contacts();
};

}  // namespace meniscus::collision
