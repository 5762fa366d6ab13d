// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Queries of a rigid world.
#include <algorithm>
#include <tuple>

#include "collision/mesh/triangle_bvh.h"
#include "collision/mesh/triangle_bvh_query.h"
#include "collision/rigid/rays.h"
#include "collision/rigid/rigid_impl.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

namespace {

constexpr uint32_t is_fixed = 1u << 31;

/// Order of solids: bodies before fixed solids, then by number.
uint32_t rank(RigidRef solid) {
  return solid.is_body ? solid.number : is_fixed | solid.number;
}
RigidRef solid_of_rank(uint32_t rank) {
  return {(rank & is_fixed) == 0, rank & ~is_fixed};
}

uint64_t key_of(uint32_t a, uint32_t b) {
  return uint64_t{a} << 32 | b;
}

bool touch_at_any_point(const btPersistentManifold& manifold) {
  bool touch = false;
  for (int p = 0; p < manifold.getNumContacts(); ++p) {
    const btManifoldPoint& point = manifold.getContactPoint(p);
    touch |= point.getDistance() <= 0 || point.m_appliedImpulse > 0;
  }
  return touch;
}

/// A contact relative to the solid that comes first.
RigidContact contact_of(const btManifoldPoint& point, RigidRef a, RigidRef b) {
  const Vec3 normal = from_bullet(point.m_normalWorldOnB);
  const float distance = point.getDistance(), impulse = mass_unit * point.m_appliedImpulse;
  if (rank(b) < rank(a)) {
    return {b, a, from_bullet(point.getPositionWorldOnA()), -normal, distance, impulse};
  }
  return {a, b, from_bullet(point.getPositionWorldOnB()), normal, distance, impulse};
}

/// Bullet's ray cast, for surfaces of triangles.
struct SurfaceHit final : btCollisionWorld::ClosestRayResultCallback {
  using ClosestRayResultCallback::ClosestRayResultCallback;
};

class NearestHit final : public btBroadphaseRayCallback {
 public:
  NearestHit(const btVector3& from, const btVector3& to) : from_(from), to_(to) {
    const btVector3 displacement = to - from;
    for (int axis = 0; axis < 3; ++axis) {
      m_rayDirectionInverse[axis] = displacement[axis] == 0 ? BT_LARGE_FLOAT : 1 / displacement[axis];
      m_signs[axis] = m_rayDirectionInverse[axis] < 0;
    }
    m_lambda_max = 1;
  }

  bool process(const btBroadphaseProxy* proxy) override {
    const auto* owner = static_cast<const btCollisionObject*>(proxy->m_clientObject);
    cast_at(*owner->getCollisionShape(), owner->getWorldTransform(), owner);
    return true;
  }

  const btCollisionObject* object = nullptr;
  ConvexRayHit hit{1, {0, 1, 0}};  ///< the normal is in world axes

 private:
  void cast_at(const btCollisionShape& shape, const btTransform& at, const btCollisionObject* owner) {
    if (shape.isCompound()) {
      const auto& compound = static_cast<const btCompoundShape&>(shape);
      for (int i = 0; i < compound.getNumChildShapes(); ++i) {
        cast_at(*compound.getChildShape(i), at * compound.getChildTransform(i), owner);
      }
    } else if (shape.isConvex()) {
      const auto& convex = static_cast<const btConvexShape&>(shape);
      if (!cast_ray_at(convex, at.invXform(from_), at.invXform(to_), hit)) return;
      hit.normal = at.getBasis() * hit.normal;
      object = owner;
    } else {
      cast_at_surface(shape, at, owner);
    }
  }

  void cast_at_surface(const btCollisionShape& shape, const btTransform& at, const btCollisionObject* owner) {
    SurfaceHit found(from_, to_);
    found.m_closestHitFraction = hit.fraction;
    const btQuaternion none = btQuaternion::getIdentity();
    btCollisionWorld::rayTestSingle(btTransform(none, from_), btTransform(none, to_),
                                    const_cast<btCollisionObject*>(owner), &shape, at, found);
    if (!found.hasHit()) return;
    hit = {found.m_closestHitFraction, found.m_hitNormalWorld};
    object = owner;
  }

  btVector3 from_, to_;
};

/// Collects the solids that overlap a probe. Bullet leaks what it made for a pair if a callback throws, so
/// the list takes its memory as Bullet does, from a reserve (collision/mesh/bullet_memory.h).
class Overlapping final : public btCollisionWorld::ContactResultCallback {
 public:
  explicit Overlapping(const btCollisionObject& probe) : probe_(&probe) {}

  bool needsCollision(btBroadphaseProxy*) const override { return true; }
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* a, int, int,
                           const btCollisionObjectWrapper* b, int, int) override {
    const btCollisionObject* other =
        a->getCollisionObject() == probe_ ? b->getCollisionObject() : a->getCollisionObject();
    if (point.getDistance() <= 0) found.push_back(other);
    return 0;
  }

  btAlignedObjectArray<const btCollisionObject*> found;

 private:
  const btCollisionObject* probe_;
};

/// Collects how deep each solid overlaps a body that may collide with it, in memory as `Overlapping`.
class DeepestOverlaps final : public btCollisionWorld::ContactResultCallback {
 public:
  explicit DeepestOverlaps(btRigidBody& body) : body_(body) {
    m_collisionFilterGroup = body.getBroadphaseHandle()->m_collisionFilterGroup;
    m_collisionFilterMask = body.getBroadphaseHandle()->m_collisionFilterMask;
  }

  bool needsCollision(btBroadphaseProxy* proxy) const override {
    return ContactResultCallback::needsCollision(proxy) &&
           body_.checkCollideWith(static_cast<const btCollisionObject*>(proxy->m_clientObject));
  }
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* a, int, int,
                           const btCollisionObjectWrapper* b, int, int) override {
    const btCollisionObject* other =
        a->getCollisionObject() == &body_ ? b->getCollisionObject() : a->getCollisionObject();
    int n = 0;
    while (n < depths.size() && depths[n].solid != other) ++n;
    if (n == depths.size()) depths.push_back({other, 0.0f});
    depths[n].depth = std::max(depths[n].depth, -point.getDistance());
    return 0;
  }

  struct Depth {
    const btCollisionObject* solid;
    float depth;
  };
  btAlignedObjectArray<Depth> depths;

 private:
  btRigidBody& body_;
};

/// Whether a point is inside a solid that is a surface for Bullet.
bool is_under(const btHeightfieldTerrainShape& field, const btVector3& local) {
  struct Above final : btTriangleCallback {
    explicit Above(const btVector3& p) : from(p) {}
    void processTriangle(btVector3* t, int, int) override {
      // Whether the triangle is above or below the point, by barycentric coordinates in the horizontal plane.
      const btVector3 u = t[1] - t[0], v = t[2] - t[0], w = from - t[0];
      const float area = u.x() * v.z() - u.z() * v.x();
      const float b = (w.x() * v.z() - w.z() * v.x()) / area, c = (u.x() * w.z() - u.z() * w.x()) / area;
      if (b >= 0 && c >= 0 && b + c <= 1) under |= w.y() < b * u.y() + c * v.y();
    }
    btVector3 from;
    bool under = false;
  } above(local);
  field.processAllTriangles(&above, local - btVector3(0, 1e9f, 0), local + btVector3(0, 1e9f, 0));
  return above.under;
}

bool is_in_mesh(const btBvhTriangleMeshShape& shape, const btVector3& local) {
  const auto* mesh = static_cast<const TriangleMesh*>(shape.getUserPointer());
  return is_inside(TriangleBvh(*mesh).view(), from_bullet(local));
}

bool is_within(const btCollisionShape& shape, const btVector3& local) {
  if (shape.isCompound()) {
    const auto& compound = static_cast<const btCompoundShape&>(shape);
    for (int i = 0; i < compound.getNumChildShapes(); ++i) {
      if (is_within(*compound.getChildShape(i), compound.getChildTransform(i).invXform(local))) return true;
    }
    return false;
  }
  if (shape.getShapeType() == TERRAIN_SHAPE_PROXYTYPE) {
    return is_under(static_cast<const btHeightfieldTerrainShape&>(shape), local);
  }
  if (shape.getShapeType() == TRIANGLE_MESH_SHAPE_PROXYTYPE) {
    return is_in_mesh(static_cast<const btBvhTriangleMeshShape&>(shape), local);
  }
  return false;
}

}  // namespace

std::vector<RigidContact> RigidWorld::contacts() const {
  const InBullet bullet(*reserve_, impl_->size());
  std::vector<RigidContact> found = impl_->contacts_on_device();
  impl_->dynamics.for_each_touching([&](const btPersistentManifold& manifold) {
    const RigidRef a = impl_->solid_of(manifold.getBody0()), b = impl_->solid_of(manifold.getBody1());
    for (int p = 0; p < manifold.getNumContacts(); ++p) {
      found.push_back(contact_of(manifold.getContactPoint(p), a, b));
    }
  });
  std::ranges::stable_sort(found, {}, [](const RigidContact& c) { return std::tuple(rank(c.a), rank(c.b)); });
  return found;
}

const std::vector<RigidTouch>& RigidWorld::touches() {
  if (impl_->knows_touches) return impl_->touches;
  const InBullet bullet(*reserve_, impl_->size());
  std::vector<uint64_t>& keys = impl_->touching_keys;
  keys.clear();
  const auto add = [&](RigidRef a, RigidRef b) {
    const uint32_t first = rank(a), second = rank(b);
    keys.push_back(key_of(std::min(first, second), std::max(first, second)));
  };
  const auto note = [&](const btPersistentManifold& manifold, RigidRef a, RigidRef b) {
    if (touch_at_any_point(manifold)) add(a, b);
  };
  impl_->dispatcher.for_each_touching([&](const btPersistentManifold& manifold, uint64_t pair) {
    note(manifold, impl_->solids[pair >> 32], impl_->solids[pair & 0xffffffff]);
  });
  for (const RigidTouch& touch : impl_->touches_on_device()) add(touch.a, touch.b);
  const auto& predictive = impl_->dynamics.predictive();
  for (int i = 0; i < predictive.size(); ++i)
    note(*predictive[i], impl_->solid_of(predictive[i]->getBody0()),
         impl_->solid_of(predictive[i]->getBody1()));
  std::ranges::sort(keys);
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  impl_->touches.clear();
  for (uint64_t key : keys)
    impl_->touches.push_back(
        {solid_of_rank(static_cast<uint32_t>(key >> 32)), solid_of_rank(static_cast<uint32_t>(key))});
  impl_->knows_touches = true;
  return impl_->touches;
}

std::vector<RigidOverlap> RigidWorld::deep_overlaps(float fraction) const {
  const InBullet bullet(*reserve_, impl_->size());
  impl_->update_boxes();
  std::vector<RigidOverlap> found;
  impl_->for_each_body([&](uint32_t n, const RigidBodyRecord& body) {
    if (body.kinematic) return;
    DeepestOverlaps deepest(*body.bullet);
    impl_->dynamics.contactTest(body.bullet.get(), deepest);
    for (int k = 0; k < deepest.depths.size(); ++k) {
      const auto& [other, depth] = deepest.depths[k];
      const RigidRef solid = impl_->solid_of(other);
      const bool seen = solid.is_body && !impl_->body(solid.number).kinematic && solid.number < n;
      const float size = solid.is_body ? std::min(body.shape.radius, impl_->body(solid.number).shape.radius)
                                       : body.shape.radius;
      if (!seen && depth > fraction * size) found.push_back({{true, n}, solid, depth});
    }
  });
  return found;
}

bool RigidWorld::cast_ray(Vec3 from, Vec3 to, RigidRayHit& hit) const {
  const InBullet bullet(*reserve_, impl_->size());
  impl_->update_boxes();
  NearestHit nearest(to_bullet(from), to_bullet(to));
  const btVector3 none(0, 0, 0);
  impl_->broadphase.rayTest(to_bullet(from), to_bullet(to), nearest, none, none);
  if (!nearest.object) return false;
  const Vec3 normal = normalized_or(from_bullet(nearest.hit.normal), normalized_or(from - to, {0, 1, 0}));
  hit = {impl_->solid_of(nearest.object), from + nearest.hit.fraction * (to - from),
         dot(normal, to - from) > 0 ? -normal : normal, nearest.hit.fraction};
  return true;
}

std::vector<RigidRef> RigidWorld::overlaps(const Pose& pose, Vec3 half_extents, bool ball) const {
  const InBullet bullet(*reserve_, impl_->size());
  impl_->update_boxes();
  btSphereShape sphere(half_extents.x);
  btBoxShape box(to_bullet(half_extents));
  btCollisionObject probe;
  probe.setCollisionShape(ball ? static_cast<btCollisionShape*>(&sphere) : &box);
  probe.setWorldTransform(to_bullet(pose));
  Overlapping overlapping(probe);
  impl_->dynamics.contactTest(&probe, overlapping);
  const btCollisionObjectArray& objects = impl_->dynamics.getCollisionObjectArray();
  for (int i = 0; i < objects.size(); ++i) {
    const btVector3 local = objects[i]->getWorldTransform().invXform(to_bullet(pose.position));
    if (is_within(*objects[i]->getCollisionShape(), local)) overlapping.found.push_back(objects[i]);
  }
  std::vector<RigidRef> found;
  for (int i = 0; i < overlapping.found.size(); ++i) found.push_back(impl_->solid_of(overlapping.found[i]));
  std::ranges::sort(found, {}, rank);
  const auto same = [](RigidRef a, RigidRef b) { return rank(a) == rank(b); };
  found.erase(std::unique(found.begin(), found.end(), same), found.end());
  return found;
}

}  // namespace meniscus::collision
