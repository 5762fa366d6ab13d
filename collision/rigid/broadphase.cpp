// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of RigidBroadphase and RigidFilter.
#include "collision/rigid/broadphase.h"

#include <algorithm>

namespace meniscus::collision {

namespace {

constexpr unsigned first_capacity = 256;

btVector3 all(float x) {
  return {x, x, x};
}

/// So is what is not a number.
bool is_outside(const btVector3& lower, const btVector3& upper) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(upper[axis] >= -RigidBroadphase::reach && lower[axis] <= RigidBroadphase::reach)) return true;
  }
  return false;
}

/// The place of a proxy outside the space. Clamped to the border, all of these would overlap. Each gets a
/// place of its own, along the edge at the low end of y and z.
btVector3 parking_place(int unique_id) {
  const float r = RigidBroadphase::reach;
  return {-r + 0.1f * static_cast<float>(unique_id % 200'000), -r, -r};
}

/// Whether the segment from `from` along `direction`, of length `length`, meets a box.
bool meets_box(const btVector3& from, const btBroadphaseRayCallback& ray, const btVector3& lower,
               const btVector3& upper) {
  const btVector3 bounds[2] = {lower, upper};
  btScalar at;
  return btRayAabb2(from, ray.m_rayDirectionInverse, ray.m_signs, bounds, at, 0, ray.m_lambda_max);
}

}  // namespace

RigidBroadphase::RigidBroadphase(btOverlappingPairCache* pairs)
    : bt32BitAxisSweep3(all(-reach), all(reach), first_capacity, pairs, true) {}

btBroadphaseProxy* RigidBroadphase::createProxy(const btVector3& lower, const btVector3& upper,
                                                int shape_type, void* owner, int group, int mask,
                                                btDispatcher* dispatcher) {
  if (m_firstFreeHandle == 0) grow();
  const bool inside = !is_outside(lower, upper);
  const btVector3 corner = all(-reach);
  btBroadphaseProxy* made = bt32BitAxisSweep3::createProxy(inside ? lower : corner, inside ? upper : corner,
                                                           shape_type, owner, group, mask, dispatcher);
  setAabb(made, lower, upper, dispatcher);
  return made;
}

void RigidBroadphase::setAabb(btBroadphaseProxy* proxy, const btVector3& lower, const btVector3& upper,
                              btDispatcher* dispatcher) {
  if (is_outside(lower, upper)) {
    const btVector3 place = parking_place(proxy->m_uniqueId);
    bt32BitAxisSweep3::setAabb(proxy, place, place, dispatcher);
  } else {
    bt32BitAxisSweep3::setAabb(proxy, lower, upper, dispatcher);
  }
}

void RigidBroadphase::rayTest(const btVector3& from, const btVector3&, btBroadphaseRayCallback& callback,
                              const btVector3& lower, const btVector3& upper) {
  for (unsigned i = 1; i < m_numHandles * 2 + 1; ++i) {
    if (!m_pEdges[0][i].IsMax()) continue;
    Handle* handle = getHandle(m_pEdges[0][i].m_handle);
    // As in Bullet's tree: a cast shape has a size, which widens the box.
    if (meets_box(from, callback, handle->m_aabbMin - upper, handle->m_aabbMax - lower)) {
      callback.process(handle);
    }
  }
}

/// Doubles the capacity and keeps all places.
void RigidBroadphase::grow() {
  const unsigned capacity = 2 * m_maxHandles;
  auto* handles = new Handle[capacity];
  std::copy_n(m_pHandles, m_maxHandles, handles);
  for (unsigned i = m_maxHandles; i < capacity; ++i) handles[i].SetNextFree(i + 1 < capacity ? i + 1 : 0);
  for (int axis = 0; axis < 3; ++axis) {
    void* raw = btAlignedAlloc(sizeof(Edge) * capacity * 2, 16);
    Edge* edges = static_cast<Edge*>(raw);
    std::copy_n(m_pEdges[axis], 2 * m_maxHandles, edges);
    btAlignedFree(m_pEdgesRawPtr[axis]);
    m_pEdgesRawPtr[axis] = raw;
    m_pEdges[axis] = edges;
  }
  m_firstFreeHandle = m_maxHandles;
  m_maxHandles = capacity;
  adopt(handles);
}

/// Moves to another array of handles, and updates all pointers to them.
void RigidBroadphase::adopt(Handle* handles) {
  for (unsigned i = 1; i < m_numHandles * 2 + 1; ++i) {
    if (!m_pEdges[0][i].IsMax()) continue;
    Handle& handle = handles[m_pEdges[0][i].m_handle];
    static_cast<btCollisionObject*>(handle.m_clientObject)->setBroadphaseHandle(&handle);
  }
  btBroadphasePairArray& pairs = m_pairCache->getOverlappingPairArray();
  for (int i = 0; i < pairs.size(); ++i) {
    pairs[i].m_pProxy0 = handles + pairs[i].m_pProxy0->m_uniqueId;
    pairs[i].m_pProxy1 = handles + pairs[i].m_pProxy1->m_uniqueId;
  }
  delete[] m_pHandles;
  m_pHandles = handles;
}

/// The proxies that each of `gone` has pairs with.
struct RigidBroadphase::Partners {
  struct Place {
    int index;  ///< among the pairs
    btBroadphaseProxy* partner;
  };
  std::vector<uint32_t> start;
  std::vector<btBroadphaseProxy*> partners;
  std::vector<Place> places;  ///< room for the pairs of any one

  Partners(std::span<btBroadphaseProxy* const> gone, const btBroadphasePairArray& pairs, unsigned handles) {
    constexpr uint32_t stays = ~0u;
    std::vector<uint32_t> number(handles, stays);
    for (uint32_t k = 0; k < gone.size(); ++k) number[static_cast<size_t>(gone[k]->m_uniqueId)] = k;
    const auto for_each = [&](const auto& visit) {
      for (int i = 0; i < pairs.size(); ++i) {
        btBroadphaseProxy *a = pairs[i].m_pProxy0, *b = pairs[i].m_pProxy1;
        const uint32_t of_a = number[static_cast<size_t>(a->m_uniqueId)];
        const uint32_t of_b = number[static_cast<size_t>(b->m_uniqueId)];
        if (of_a != stays) visit(of_a, b);
        if (of_b != stays) visit(of_b, a);
      }
    };
    start.assign(gone.size() + 2, 0);
    for_each([&](uint32_t k, btBroadphaseProxy*) { ++start[k + 2]; });
    size_t most = 0;
    for (size_t k = 2; k < start.size(); ++k) {
      most = std::max<size_t>(most, start[k]);
      start[k] += start[k - 1];
    }
    places.reserve(most);
    partners.resize(start.back());
    for_each([&](uint32_t k, btBroadphaseProxy* partner) { partners[start[k + 1]++] = partner; });
  }

  /// Removes the pairs of the k-th. Bullet removes the first of them in the array, moves the last pair of the
  /// array to its place, and looks at that place again.
  void drop(uint32_t k, btBroadphaseProxy* proxy, btOverlappingPairCache& cache, btDispatcher* dispatcher) {
    const btBroadphasePairArray& pairs = cache.getOverlappingPairArray();
    places.clear();
    for (uint32_t n = start[k]; n < start[k + 1]; ++n) {
      if (btBroadphasePair* pair = cache.findPair(proxy, partners[n]))
        places.push_back({static_cast<int>(pair - &pairs[0]), partners[n]});
    }
    std::ranges::sort(places, {}, &Place::index);
    for (size_t first = 0, end = places.size(); first < end;) {
      const int last = pairs.size() - 1;
      cache.removeOverlappingPair(proxy, places[first].partner, dispatcher);
      if (first + 1 < end && places[end - 1].index == last)
        places[first].partner = places[--end].partner;
      else
        ++first;
    }
  }
};

void RigidBroadphase::destroy_all(std::span<btBroadphaseProxy* const> gone, btDispatcher* dispatcher) {
  Partners partners(gone, m_pairCache->getOverlappingPairArray(), m_maxHandles);
  std::vector<bool> is_gone(m_maxHandles);
  for (const btBroadphaseProxy* proxy : gone) is_gone[static_cast<size_t>(proxy->m_uniqueId)] = true;
  for (uint32_t k = 0; k < gone.size(); ++k) partners.drop(k, gone[k], *m_pairCache, dispatcher);
  drop_edges(is_gone, static_cast<unsigned>(gone.size()));
  for (const btBroadphaseProxy* proxy : gone) freeHandle(static_cast<unsigned>(proxy->m_uniqueId));
}

/// Closes the gaps that the edges of `count` proxies leave.
void RigidBroadphase::drop_edges(const std::vector<bool>& is_gone, unsigned count) {
  const unsigned end = 2 * m_numHandles + 1;  // the place of the sentinel
  for (int axis = 0; axis < 3; ++axis) {
    Edge* edges = m_pEdges[axis];
    unsigned to = 1;
    for (unsigned from = 1; from < end; ++from) {
      const Edge edge = edges[from];
      if (is_gone[edge.m_handle]) continue;
      Handle& handle = m_pHandles[edge.m_handle];
      (edge.IsMax() ? handle.m_maxEdges : handle.m_minEdges)[axis] = to;
      edges[to++] = edge;
    }
    edges[to] = edges[end];
    m_pHandles[0].m_maxEdges[axis] -= 2 * count;
  }
}

void RigidBroadphase::save(State& state) const {
  state.bounds.resize(m_maxHandles);
  for (unsigned i = 0; i < m_maxHandles; ++i) {
    const Handle& from = m_pHandles[i];
    Bounds& to = state.bounds[i];
    to.lower = from.m_aabbMin;
    to.upper = from.m_aabbMax;
    std::copy_n(from.m_minEdges, 3, to.first);
    std::copy_n(from.m_maxEdges, 3, to.last);
  }
  for (int axis = 0; axis < 3; ++axis) {
    state.edges[axis].assign(m_pEdges[axis], m_pEdges[axis] + 2 * m_numHandles + 2);
  }
  state.first_free = m_firstFreeHandle;
}

void RigidBroadphase::restore(const State& state) {
  for (unsigned i = 0; i < state.bounds.size(); ++i) {
    const Bounds& from = state.bounds[i];
    Handle& to = m_pHandles[i];
    to.m_aabbMin = from.lower;
    to.m_aabbMax = from.upper;
    std::copy_n(from.first, 3, to.m_minEdges);
    std::copy_n(from.last, 3, to.m_maxEdges);
  }
  for (int axis = 0; axis < 3; ++axis) std::ranges::copy(state.edges[axis], m_pEdges[axis]);
  m_firstFreeHandle = state.first_free;
}

std::vector<RigidBroadphase::PlainEdge> RigidBroadphase::plain(const std::vector<Edge>& edges) {
  std::vector<PlainEdge> plain;
  for (const Edge& e : edges) plain.push_back({e.m_pos, e.m_handle});
  return plain;
}

std::vector<RigidBroadphase::Edge> RigidBroadphase::edges_of(const std::vector<PlainEdge>& plain) {
  std::vector<Edge> edges(plain.size());
  for (size_t k = 0; k < plain.size(); ++k) {
    edges[k].m_pos = plain[k].position;
    edges[k].m_handle = plain[k].proxy;
  }
  return edges;
}

void RigidBroadphase::make_room(unsigned proxies) {
  while (m_maxHandles < proxies) grow();
}

void RigidBroadphase::give_next(unsigned proxy) {
  make_room(proxy + 1);
  m_firstFreeHandle = proxy;
}

/// Unused handles are in no edge. The first one stands for the ends of the axes.
bool RigidBroadphase::has(int unique_id) const {
  for (unsigned i = 1; i < m_numHandles * 2 + 1; ++i) {
    if (m_pEdges[0][i].m_handle == static_cast<unsigned>(unique_id)) return true;
  }
  return false;
}

/// Bullet's sort ends at the first edge and at the last one.
bool RigidBroadphase::stands_in_order(const std::vector<Edge>& axis) {
  if (axis.size() < 2) return false;
  const Edge &first = axis.front(), &last = axis.back();
  const auto below = [](const Edge& a, const Edge& b) { return a.m_pos < b.m_pos; };
  return first.m_pos == 0 && first.m_handle == 0 && last.m_handle == 0 &&
         std::is_sorted(axis.begin(), axis.end(), below);
}

bool RigidBroadphase::suits(const State& state) const {
  const size_t edges = 2 * size_t{m_numHandles} + 2;
  if (state.bounds.size() > m_maxHandles || state.first_free >= m_maxHandles) return false;
  std::vector<unsigned> expected, found;
  for (unsigned i = 0; i < edges; ++i) expected.push_back(m_pEdges[0][i].m_handle);
  std::ranges::sort(expected);
  for (const std::vector<Edge>& axis : state.edges) {
    if (!stands_in_order(axis)) return false;
    found.clear();
    for (const Edge& e : axis) found.push_back(e.m_handle);
    std::ranges::sort(found);
    if (found != expected) return false;
  }
  for (const unsigned proxy : expected) {
    if (proxy >= state.bounds.size()) return false;
    const Bounds& b = state.bounds[proxy];
    for (int axis = 0; axis < 3; ++axis) {
      const bool ends = proxy == 0;  // the first edge and the last one
      if (ends) continue;
      if (b.first[axis] >= edges || b.last[axis] >= edges) return false;
      if (state.edges[axis][b.first[axis]].m_handle != proxy) return false;
      if (state.edges[axis][b.last[axis]].m_handle != proxy) return false;
    }
  }
  return true;
}

bool RigidFilter::needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const {
  const auto* of_a = static_cast<const btCollisionObject*>(a->m_clientObject);
  const auto* of_b = static_cast<const btCollisionObject*>(b->m_clientObject);
  if (of_a->isStaticOrKinematicObject() && of_b->isStaticOrKinematicObject()) return false;
  return (a->m_collisionFilterGroup & b->m_collisionFilterMask) != 0 &&
         (b->m_collisionFilterGroup & a->m_collisionFilterMask) != 0;
}

}  // namespace meniscus::collision
