// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the solids that are near one another: Bullet's sweep and prune along three axes. All of its state is
// in plain arrays, so it can be saved and restored exactly. A tree with fat boxes would depend on history.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "collision/rigid/bullet.h"

namespace meniscus::collision {

class RigidBroadphase final : public bt32BitAxisSweep3 {
 public:
  /// Half the width of the space that is swept, m. A solid wholly outside it collides with planes alone.
  static constexpr float reach = 1e4f;

  explicit RigidBroadphase(btOverlappingPairCache* pairs);

  btBroadphaseProxy* createProxy(const btVector3& lower, const btVector3& upper, int shape_type, void* owner,
                                 int group, int mask, btDispatcher* dispatcher) override;
  void setAabb(btBroadphaseProxy* proxy, const btVector3& lower, const btVector3& upper,
               btDispatcher* dispatcher) override;
  void rayTest(const btVector3& from, const btVector3& to, btBroadphaseRayCallback& callback,
               const btVector3& lower, const btVector3& upper) override;

  /// Leaves what destroyProxy() of each would leave, in this order, with pairs and edges in the same order.
  /// Takes memory before it changes anything. Edges are gone through once for all.
  void destroy_all(std::span<btBroadphaseProxy* const> gone, btDispatcher* dispatcher);

  btBroadphaseProxy* proxy(int unique_id) { return getHandle(static_cast<unsigned>(unique_id)); }

  struct Bounds {
    btVector3 lower, upper;
    unsigned first[3], last[3];  ///< places of the two edges on each axis
  };
  struct State {
    std::vector<Bounds> bounds;
    std::vector<Edge> edges[3];
    unsigned first_free = 0;
  };
  void save(State& state) const;
  void restore(const State& state);  ///< the same proxies, and no pairs

  /// The edge of a box, apart from Bullet's struct.
  struct PlainEdge {
    uint32_t position, proxy;
  };
  static std::vector<PlainEdge> plain(const std::vector<Edge>& edges);
  static std::vector<Edge> edges_of(const std::vector<PlainEdge>& edges);

  unsigned room() const { return m_maxHandles; }
  void make_room(unsigned proxies);
  /// The next proxy that is made is this one, which must be free.
  void give_next(unsigned proxy);
  bool has(int unique_id) const;
  /// Whether a state is of these proxies, and all of its indices are valid.
  bool suits(const State& state) const;

 private:
  struct Partners;
  static bool stands_in_order(const std::vector<Edge>& axis);
  void grow();
  void drop_edges(const std::vector<bool>& is_gone, unsigned count);
  void adopt(Handle* handles);
};

/// Applies masks as CollisionFilter defines them. At least one of the two solids must be dynamic.
struct RigidFilter final : public btOverlapFilterCallback {
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override;
};

}  // namespace meniscus::collision
