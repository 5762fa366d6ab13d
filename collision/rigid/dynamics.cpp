// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of RigidDispatcher and RigidDynamics.
#include "collision/rigid/dynamics.h"

#include <algorithm>

namespace meniscus::collision {

RigidDispatcher::RigidDispatcher(btCollisionConfiguration* configuration, btOverlappingPairCache* pairs)
    : btCollisionDispatcher(configuration), pairs_(pairs) {
  // Compounds are tested part by part. Bullet's algorithm for two compounds keeps a cache in the order of
  // events.
  registerCollisionCreateFunc(
      COMPOUND_SHAPE_PROXYTYPE, COMPOUND_SHAPE_PROXYTYPE,
      configuration->getCollisionAlgorithmCreateFunc(COMPOUND_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE));
  for (int kind = 0; kind < MAX_BROADPHASE_COLLISION_TYPES; ++kind) {
    if (!btBroadphaseProxy::isConvex(kind)) continue;
    registerCollisionCreateFunc(kind, STATIC_PLANE_PROXYTYPE, &plane_second_);
    registerCollisionCreateFunc(STATIC_PLANE_PROXYTYPE, kind, &plane_first_);
  }
}

bool RigidDispatcher::needsCollision(const btCollisionObject* a, const btCollisionObject* b) {
  return every_pair_ || btCollisionDispatcher::needsCollision(a, b);
}

void RigidDispatcher::dispatchAllCollisionPairs(btOverlappingPairCache*, const btDispatcherInfo& info,
                                                btDispatcher*) {
  order_pairs();
  btBroadphasePairArray& pairs = pairs_->getOverlappingPairArray();
  for (const PairPlace& place : order_) (*getNearCallback())(pairs[place.index], *this, info);
  follow_order();
}

void RigidDispatcher::order_pairs() {
  const btBroadphasePairArray& pairs = pairs_->getOverlappingPairArray();
  order_.clear();
  for (int i = 0; i < pairs.size(); ++i) {
    const auto a = static_cast<uint64_t>(pairs[i].m_pProxy0->m_uniqueId);
    order_.push_back({a << 32 | static_cast<uint64_t>(pairs[i].m_pProxy1->m_uniqueId), i});
  }
  std::ranges::sort(order_, {}, &PairPlace::key);
}

void RigidDispatcher::order_manifolds() {
  order_pairs();
  follow_order();
}

void RigidDispatcher::follow_order() {
  const btBroadphasePairArray& pairs = pairs_->getOverlappingPairArray();
  ordered_.resizeNoInitialize(0);
  touching_.clear();
  for (const PairPlace& place : order_) {
    if (!pairs[place.index].m_algorithm) continue;
    int i = ordered_.size();
    pairs[place.index].m_algorithm->getAllContactManifolds(ordered_);
    for (; i < ordered_.size(); ++i) {
      btPersistentManifold* manifold = ordered_[i];
      manifold->m_index1a = i;
      const auto points = static_cast<uint32_t>(manifold->getNumContacts());
      if (points) touching_.push_back({manifold, &manifold->getContactPoint(0), points, place.key});
    }
  }
  const int of_pairs = ordered_.size();
  for (int i = 0; i < m_manifoldsPtr.size(); ++i) {
    btPersistentManifold* other = m_manifoldsPtr[i];
    if (other->m_index1a < of_pairs && ordered_[other->m_index1a] == other) continue;
    other->m_index1a = ordered_.size();
    ordered_.push_back(other);
  }
  m_manifoldsPtr.copyFromArray(ordered_);
  in_order_ = true;
}

/// Bullet moves the last manifold into its place. So the manifolds are out of order, and the list of those
/// with contacts is out of date.
void RigidDispatcher::releaseManifold(btPersistentManifold* manifold) {
  btCollisionDispatcher::releaseManifold(manifold);
  in_order_ = false;
}

void RigidDynamics::remove_all(std::span<btRigidBody* const> gone) {
  int numbers = 0;
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i)
    numbers = std::max(numbers, m_nonStaticRigidBodies[i]->getUserIndex() + 1);
  std::vector<int> place(static_cast<size_t>(numbers));  // by the body's number
  const auto note = [&](int i) { place[static_cast<size_t>(m_nonStaticRigidBodies[i]->getUserIndex())] = i; };
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) note(i);
  for (btRigidBody* body : gone) {
    body->setBroadphaseHandle(nullptr);
    if (!body->isStaticObject()) {
      const int at = place[static_cast<size_t>(body->getUserIndex())];
      m_nonStaticRigidBodies.swap(at, m_nonStaticRigidBodies.size() - 1);
      m_nonStaticRigidBodies.pop_back();
      if (at < m_nonStaticRigidBodies.size()) note(at);
    }
    btCollisionWorld::removeCollisionObject(body);
  }
}

void RigidDynamics::forget_all() {
  for (int i = 0; i < m_collisionObjects.size(); ++i) m_collisionObjects[i]->setBroadphaseHandle(nullptr);
  m_collisionObjects.clear();
  m_nonStaticRigidBodies.clear();
  m_constraints.clear();
}

void RigidDynamics::add_joint(btTypedConstraint& joint) {
  addConstraint(&joint, false);
  joint.setUserConstraintId(m_constraints.size() - 1);
}

void RigidDynamics::remove_joint(btTypedConstraint& joint) {
  const int at = joint.getUserConstraintId();
  m_constraints.swap(at, m_constraints.size() - 1);
  m_constraints.pop_back();
  if (at < m_constraints.size()) m_constraints[at]->setUserConstraintId(at);
  joint.getRigidBodyA().removeConstraintRef(&joint);
  joint.getRigidBodyB().removeConstraintRef(&joint);
}

void RigidDynamics::detect(float dt) {
  releasePredictiveContacts();
  getDispatchInfo().m_timeStep = dt;
  performDiscreteCollisionDetection();
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
    const btRigidBody& body = *m_nonStaticRigidBodies[i];
    detected[static_cast<size_t>(body.getUserIndex())] = body.getWorldTransform();
  }
}

void RigidDynamics::order_objects(const std::vector<btRigidBody*>& objects) {
  for (int i = 0; i < m_collisionObjects.size(); ++i) {
    m_collisionObjects[i] = objects[static_cast<size_t>(i)];
    m_collisionObjects[i]->setWorldArrayIndex(i);
  }
}

void RigidDynamics::order_moving(const std::vector<btRigidBody*>& bodies) {
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i)
    m_nonStaticRigidBodies[i] = bodies[static_cast<size_t>(i)];
}

void RigidDynamics::order_joints(const std::vector<btTypedConstraint*>& joints) {
  for (int i = 0; i < m_constraints.size(); ++i) m_constraints[i] = joints[static_cast<size_t>(i)];
}

/// The rest of Bullet's internalSingleStepSimulation, after contacts are found.
void RigidDynamics::advance(float dt) {
  applyGravity();
  predictUnconstraintMotion(dt);
  createPredictiveContacts(dt);
  prepare_contacts();
  calculateSimulationIslands();
  getSolverInfo().m_timeStep = dt;
  solveConstraints(getSolverInfo());
  integrateTransforms(dt);
  updateActivationState(dt);
}

namespace {

/// Velocity of a body's point at the end of a step without contacts.
btVector3 free_velocity(const btRigidBody& body, const btVector3& point, float dt) {
  const btVector3 v = body.getLinearVelocity() + dt * body.getInvMass() * body.getTotalForce();
  const btVector3 w =
      body.getAngularVelocity() + dt * (body.getInvInertiaTensorWorld() * body.getTotalTorque());
  return v + w.cross(point - body.getCenterOfMassPosition());
}

/// Bullet bounds friction along two directions separately. With the first direction along the expected slip,
/// the bound is Coulomb's cone. This also holds for a body at rest on a slope that is oblique to the axes.
void aim_friction(btManifoldPoint& point, const btVector3& velocity) {
  const btVector3& n = point.m_normalWorldOnB;
  const btVector3 slip = velocity - n.dot(velocity) * n;
  const float speed = slip.length();
  if (speed > 1e-6f) {
    point.m_lateralFrictionDir1 = slip / speed;
    point.m_lateralFrictionDir2 = point.m_lateralFrictionDir1.cross(n);
  } else {
    btPlaneSpace1(n, point.m_lateralFrictionDir1, point.m_lateralFrictionDir2);
  }
  point.m_contactPointFlags |= BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
}

/// Bullet subtracts from the speed of a bounce what would close the gap in one step. This brakes a body
/// before it arrives, or stops it. Here a body that arrives in this step bounces as if the gap were closed,
/// and another one does not bounce yet.
void close_gap(btManifoldPoint& point, const btVector3& velocity, float dt, float resting_speed) {
  const float approach = -point.m_normalWorldOnB.dot(velocity), gap = point.getDistance();
  if (point.m_combinedRestitution == 0 || approach <= resting_speed || gap <= 0) return;
  if (gap < approach * dt)
    point.setDistance(0);
  else
    point.m_combinedRestitution = 0;
}

}  // namespace

void RigidDynamics::prepare_contacts() {
  const float dt = getDispatchInfo().m_timeStep;
  for_each_touching([&](btPersistentManifold& manifold) {
    const btRigidBody& a = *btRigidBody::upcast(manifold.getBody0());
    const btRigidBody& b = *btRigidBody::upcast(manifold.getBody1());
    const float restitution = btManifoldResult::calculateCombinedRestitution(&a, &b);
    for (int p = 0; p < manifold.getNumContacts(); ++p) {
      btManifoldPoint& point = manifold.getContactPoint(p);
      point.m_combinedRestitution = restitution;
      const btVector3 velocity = free_velocity(a, point.getPositionWorldOnA(), dt) -
                                 free_velocity(b, point.getPositionWorldOnB(), dt);
      aim_friction(point, velocity);
      close_gap(point, velocity, dt, getSolverInfo().m_restitutionVelocityThreshold);
    }
  });
}

}  // namespace meniscus::collision
