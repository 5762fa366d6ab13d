// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the contacts of convex shapes with planes.
#include "collision/rigid/plane.h"

#include <new>

namespace meniscus::collision {

namespace {

using Points = btAlignedObjectArray<btVector3>;

/// Adds four points on the rim of each end, one of them the deepest. For an upright cylinder they are always
/// the same four, so that it stands still. `down` is in the shape's frame.
void add_rims(const btCylinderShape& cylinder, const btVector3& down, Points& points) {
  const btVector3 half = cylinder.getHalfExtentsWithMargin();
  const btVector3 across(down.x(), 0, down.z());
  const btVector3 deepest = across.length2() > 4e-4f ? across.normalized() : btVector3(1, 0, 0);
  const btVector3 beside(deepest.z(), 0, -deepest.x());
  for (const float end : {-half.y(), half.y()}) {
    for (const btVector3& d : {deepest, -deepest, beside, -beside}) {
      points.push_back(half.x() * d + btVector3(0, end, 0));
    }
  }
}

/// Finds the points of a shape that may be nearest to a plane.
void find_points(const btConvexShape& shape, const btVector3& down, Points& points) {
  points.resizeNoInitialize(0);
  if (shape.getShapeType() == CYLINDER_SHAPE_PROXYTYPE) {
    add_rims(static_cast<const btCylinderShape&>(shape), down, points);
  } else if (shape.getShapeType() == CAPSULE_SHAPE_PROXYTYPE) {
    const auto& capsule = static_cast<const btCapsuleShape&>(shape);
    for (const float end : {-capsule.getHalfHeight(), capsule.getHalfHeight()}) {
      points.push_back(btVector3(0, end, 0) + capsule.getRadius() * down);
    }
  } else if (shape.isPolyhedral()) {
    const auto& polyhedron = static_cast<const btPolyhedralConvexShape&>(shape);
    const float rounding = shape.getShapeType() == BOX_SHAPE_PROXYTYPE ? 0 : shape.getMargin();
    for (int v = 0; v < polyhedron.getNumVertices(); ++v) {
      btVector3 corner;
      polyhedron.getVertex(v, corner);
      points.push_back(corner + rounding * down);
    }
  } else {
    points.push_back(shape.localGetSupportingVertex(down));
  }
}

class Algorithm final : public btCollisionAlgorithm {
 public:
  Algorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* convex,
            const btCollisionObjectWrapper* plane, bool plane_first)
      : btCollisionAlgorithm(info), manifold_(info.m_manifold), plane_first_(plane_first) {
    if (manifold_) return;
    manifold_ = m_dispatcher->getNewManifold(convex->getCollisionObject(), plane->getCollisionObject());
    owns_manifold_ = true;
  }
  ~Algorithm() override {
    if (owns_manifold_) m_dispatcher->releaseManifold(manifold_);
  }

  void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                        const btDispatcherInfo&, btManifoldResult* result) override {
    const btCollisionObjectWrapper &convex = *(plane_first_ ? b : a), &other = *(plane_first_ ? a : b);
    const auto& plane = *static_cast<const btStaticPlaneShape*>(other.getCollisionShape());
    const btTransform& from = convex.getWorldTransform();
    const btVector3 normal = other.getWorldTransform().getBasis() * plane.getPlaneNormal();
    const btVector3 on_plane =
        other.getWorldTransform() * (plane.getPlaneConstant() * plane.getPlaneNormal());
    find_points(*static_cast<const btConvexShape*>(convex.getCollisionShape()), -normal * from.getBasis(),
                points_);
    result->setPersistentManifold(manifold_);
    for (int i = 0; i < points_.size(); ++i) {
      const btVector3 point = from * points_[i];
      const float distance = normal.dot(point - on_plane);
      if (distance > manifold_->getContactBreakingThreshold()) continue;
      // In the order of the manifold, which may differ from that of the result.
      result->addContactPoint(normal, point - distance * normal, distance);
    }
    if (owns_manifold_) result->refreshContactPoints();
  }

  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1;
  }
  void getAllContactManifolds(btManifoldArray& manifolds) override {
    if (owns_manifold_) manifolds.push_back(manifold_);
  }

 private:
  btPersistentManifold* manifold_;
  bool owns_manifold_ = false, plane_first_;
  Points points_;
};

}  // namespace

btCollisionAlgorithm* RigidPlaneContacts::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                                   const btCollisionObjectWrapper* a,
                                                                   const btCollisionObjectWrapper* b) {
  void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(Algorithm));
  return new (memory) Algorithm(info, m_swapped ? b : a, m_swapped ? a : b, m_swapped);
}

}  // namespace meniscus::collision
