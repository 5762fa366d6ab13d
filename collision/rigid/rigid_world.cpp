// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contents of a rigid world: solids, bodies, and their state.
#include "collision/rigid/rigid_world.h"

#include <cassert>
#include <cmath>

#include "collision/rigid/rigid_impl.h"
#include "collision/rigid/tuning.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

namespace {

btRigidBody::btRigidBodyConstructionInfo info_of(const RigidSolid& solid, const RigidShape& shape,
                                                 float mass) {
  btRigidBody::btRigidBodyConstructionInfo info(mass / mass_unit, nullptr, shape.root,
                                                in_mass_units(shape.inertia));
  info.m_startWorldTransform = to_bullet(solid.pose) * to_bullet(shape.frame);
  // Bullet multiplies the coefficients of two solids.
  info.m_friction = std::sqrt(solid.friction);
  info.m_restitution = std::sqrt(solid.restitution);
  return info;
}

/// Sets the thresholds that depend on a body's size. Small bodies sleep at lower speeds than large ones.
/// Without gravity none sleeps, because sleep would stop a drifting body. A body is swept if it moves so far
/// in a step that it could pass through something.
void scale_to_size(btRigidBody& body, const RigidShape& shape, float gravity) {
  const float speed = rigid_tuning::sleep_speed * std::sqrt(gravity * shape.radius);
  body.setSleepingThresholds(speed, speed / shape.radius);
  body.setCcdMotionThreshold(rigid_tuning::swept_motion * shape.inner_radius);
  body.setCcdSweptSphereRadius(rigid_tuning::swept_radius * shape.inner_radius);
}

void place(btRigidBody& body, const btTransform& at) {
  body.setWorldTransform(at);
  body.setInterpolationWorldTransform(at);
  body.updateInertiaTensor();
}

}  // namespace

void set_speed(btRigidBody& body, Vec3 linear, Vec3 angular) {
  body.setLinearVelocity(to_bullet(linear));
  body.setAngularVelocity(to_bullet(angular));
  body.setInterpolationLinearVelocity(to_bullet(linear));
  body.setInterpolationAngularVelocity(to_bullet(angular));
}

void wake_up(btRigidBody& body) {
  body.activate(true);
}

RigidWorld::Impl::Impl(const RigidWorldDef& definition, BulletReserve& held_back)
    : reserve(held_back),
      def(definition),
      broadphase(&pairs),
      dispatcher(&configuration, &pairs),
      dynamics(&dispatcher, &broadphase, &solver, &configuration),
      ground(0, nullptr, nullptr) {
  pairs.setOverlapFilterCallback(&filter);
  dynamics.setGravity(to_bullet(def.gravity));
  dynamics.setForceUpdateAllAabbs(false);
  dynamics.setApplySpeculativeContactRestitution(true);
  dynamics.getDispatchInfo().m_deterministicOverlappingPairs = true;
  dynamics.getDispatchInfo().m_allowedCcdPenetration = 0;
  btContactSolverInfo& info = dynamics.getSolverInfo();
  info.m_numIterations = def.iterations;
  info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS | SOLVER_ENABLE_FRICTION_DIRECTION_CACHING;
  // Starts from all of the last step's impulses. With the usual 0.85 a stack must find the rest again in each
  // step.
  info.m_warmstartingFactor = 1;
  // Overlaps are removed separately from velocities, so that they add no energy. All overlaps are, not only
  // those beyond 4 cm.
  info.m_splitImpulse = true;
  info.m_splitImpulsePenetrationThreshold = 0;
}

/// Removes pairs from the last to the first, so that none moves to another's place.
void RigidWorld::Impl::drop_pairs() {
  while (pairs.getNumOverlappingPairs() > 0) {
    const btBroadphasePair last = pairs.getOverlappingPairArray()[pairs.getNumOverlappingPairs() - 1];
    pairs.removeOverlappingPair(last.m_pProxy0, last.m_pProxy1, &dispatcher);
  }
}

RigidWorld::Impl::~Impl() {
  drop_pairs();  // otherwise each body would search all of them for its own
  dynamics.release_predictive();
  dynamics.forget_all();
}

RigidBodyRecord& RigidWorld::Impl::body(uint32_t n) const {
  assert(bodies.has(n));
  return *bodies.slots[n];
}

float RigidWorld::Impl::acceleration_scale() const {
  return pbd::max(length(def.gravity), rigid_tuning::least_gravity);
}

void RigidWorld::Impl::add(btRigidBody& body, const CollisionFilter& meets, const RigidPlace& place) {
  parts_changed = true;
  if (place.proxy != pbd::no_index) broadphase.give_next(place.proxy);
  dynamics.addRigidBody(&body, static_cast<int>(meets.groups), static_cast<int>(meets.mask));
  const auto proxy = static_cast<size_t>(body.getBroadphaseHandle()->m_uniqueId);
  if (solids.size() <= proxy) solids.resize(proxy + 1);  // without new memory: see prepare()
  solids[proxy] = solid_of(&body);
}

/// Takes the memory that add() needs, while nothing has changed yet.
void RigidWorld::Impl::prepare() {
  const size_t proxies = bodies.slots.size() + fixed.slots.size() + 2;  // their ids are at most this
  if (solids.capacity() < proxies) solids.reserve(2 * proxies);
  bodies.prepare();
  fixed.prepare();
  if (dynamics.detected.capacity() <= bodies.slots.size())
    dynamics.detected.reserve(2 * bodies.slots.size() + 1);
}

RigidRef RigidWorld::Impl::solid_of(const btCollisionObject* object) const {
  return {!object->isStaticObject(), static_cast<uint32_t>(object->getUserIndex())};
}

btRigidBody* RigidWorld::Impl::object(uint32_t code) const {
  const uint32_t n = code / 2;
  if (code % 2) return bodies.has(n) ? bodies.slots[n]->bullet.get() : nullptr;
  return fixed.has(n) ? fixed.slots[n]->bullet.get() : nullptr;
}

void RigidWorld::Impl::wake_around(std::span<btRigidBody* const> changed) {
  constexpr int is_changed = 1, is_other = -1;  // Bullet's default
  for (btRigidBody* body : changed) body->setUserIndex2(is_changed);
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    if (manifold.getNumContacts() == 0) continue;
    const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
    if (a->getUserIndex2() == is_changed) b->activate();
    if (b->getUserIndex2() == is_changed) a->activate();
  }
  for (btRigidBody* body : changed) body->setUserIndex2(is_other);
  wake_resting(changed);
  for (btRigidBody* body : changed) {
    if (body->isStaticObject()) continue;  // joints are of bodies
    for (const uint32_t n : this->body(static_cast<uint32_t>(body->getUserIndex())).joints) {
      joints.slots[n]->bullet->getRigidBodyA().activate();
      joints.slots[n]->bullet->getRigidBodyB().activate();
    }
  }
}

RigidWorld::RigidWorld(const RigidWorldDef& def) : reserve_(std::make_unique<BulletReserve>()) {
  const InBullet bullet(*reserve_, 0);
  impl_.reset(new Impl(def, *reserve_));
}
RigidWorld::~RigidWorld() = default;

void RigidWorld::DeleteImpl::operator()(Impl* impl) const {
  if (!impl->reserve.is_broken()) delete impl;  // Bullet's destructors would meet what is half made
}

bool RigidWorld::is_broken() const {
  return reserve_->is_broken();
}

void RigidWorld::set_def(const RigidWorldDef& def) {
  impl_->def = def;
  impl_->dynamics.getSolverInfo().m_numIterations = def.iterations;
  // Bullet sets the gravity of awake bodies alone.
  for (const auto& body : impl_->bodies.slots) {
    if (!body) continue;
    wake_up(*body->bullet);
    scale_to_size(*body->bullet, body->shape, length(def.gravity));
  }
  impl_->dynamics.setGravity(to_bullet(def.gravity));
}

uint32_t RigidWorld::add_fixed(const RigidSolid& solid, const RigidPlace& place) {
  const InBullet bullet(*reserve_, impl_->size());
  impl_->prepare();
  auto made = std::make_unique<RigidFixedRecord>();
  made->shape = make_rigid_shape(solid.parts, nullptr);
  made->contact = impl_->contact_solid(solid);
  made->bullet = std::make_unique<btRigidBody>(info_of(solid, made->shape, 0));
  btRigidBody& body = *made->bullet;
  const uint32_t number = impl_->fixed.add_at(place.number, std::move(made));
  body.setUserIndex(static_cast<int>(number));
  impl_->add(body, solid.filter, place);
  return number;
}

uint32_t RigidWorld::add_body(const RigidBodyDef& def, const RigidPlace& place) {
  const InBullet bullet_memory(*reserve_, impl_->size());
  impl_->prepare();
  auto made = std::make_unique<RigidBodyRecord>();
  made->name = def.name;
  made->kinematic = def.motion == BodyMotion::kinematic;
  made->shape = make_rigid_shape(def.solid.parts, made->kinematic ? nullptr : &def.mass);
  made->contact = impl_->contact_solid(def.solid);
  const float mass = made->kinematic ? 0 : static_cast<float>(def.mass.mass);
  btRigidBody::btRigidBodyConstructionInfo info = info_of(def.solid, made->shape, mass);
  info.m_linearDamping = def.linear_damping;
  info.m_angularDamping = def.angular_damping;
  made->bullet = std::make_unique<btRigidBody>(info);
  btRigidBody& bullet = *made->bullet;
  if (made->kinematic) {
    // Not static, which is Bullet's default for bodies without mass.
    bullet.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    made->keyframes = def.keyframes;
    made->loop = def.loop;
    made->memory.drive = def.keyframes.empty() ? KinematicDrive::still : KinematicDrive::keyframes;
    made->memory.pose = def.solid.pose;
    impl_->place_kinematic(*made, impl_->kinematic_pose(*made, impl_->time));
  } else {
    set_speed(bullet, def.velocity, def.angular_velocity);
    bullet.setFlags(bullet.getFlags() & ~BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);  // see tumbled()
  }
  scale_to_size(bullet, made->shape, length(impl_->def.gravity));
  if (!def.can_sleep) bullet.setActivationState(DISABLE_DEACTIVATION);

  const uint32_t number = impl_->bodies.add_at(place.number, std::move(made));
  bullet.setUserIndex(static_cast<int>(number));
  impl_->dynamics.detected.resize(impl_->bodies.slots.size(), btTransform::getIdentity());
  impl_->dynamics.detected[number] = bullet.getWorldTransform();
  impl_->add(bullet, def.solid.filter, place);
  return number;
}

void RigidWorld::remove(std::span<const RigidRef> solids) {
  if (solids.empty()) return;
  const InBullet bullet_memory(*reserve_, impl_->size());
  std::vector<btRigidBody*> gone;
  std::vector<btBroadphaseProxy*> proxies;
  std::vector<uint32_t> joints;
  for (const RigidRef& solid : solids) {
    gone.push_back(solid.is_body ? impl_->body(solid.number).bullet.get()
                                 : impl_->fixed.slots[solid.number]->bullet.get());
    proxies.push_back(gone.back()->getBroadphaseHandle());
    if (!solid.is_body) continue;
    const std::vector<uint32_t>& its = impl_->body(solid.number).joints;
    joints.insert(joints.end(), its.begin(), its.end());
  }
  if (impl_->def.on_device) impl_->removed.insert(impl_->removed.end(), solids.begin(), solids.end());
  impl_->remove(gone, proxies);
  for (const uint32_t joint : joints) {
    if (has_joint(joint)) impl_->remove_joint(joint);
  }
  for (const RigidRef& solid : solids)
    solid.is_body ? impl_->bodies.remove(solid.number) : impl_->fixed.remove(solid.number);
}

/// Predictive contacts wake what is beside the first alone, and then end.
void RigidWorld::Impl::remove(std::span<btRigidBody* const> gone,
                              std::span<btBroadphaseProxy* const> proxies) {
  wake_around(gone.first(1));
  dynamics.release_predictive();
  if (gone.size() > 1) wake_around(gone);
  broadphase.destroy_all(proxies, &dispatcher);
  dynamics.remove_all(gone);
  dispatcher.note_disorder();
  knows_touches = false;
  parts_changed = true;
}

const std::vector<uint32_t>& RigidWorld::joints_of(uint32_t body) const {
  return impl_->body(body).joints;
}

uint32_t RigidWorld::body_slots() const {
  return static_cast<uint32_t>(impl_->bodies.slots.size());
}

uint32_t RigidWorld::body_count() const {
  uint32_t count = 0;
  for (const auto& body : impl_->bodies.slots) count += body != nullptr;
  return count;
}

RigidMass RigidWorld::mass(uint32_t number) const {
  if (!impl_->bodies.has(number)) return {0, {0, 0, 0}, {}};
  const RigidBodyRecord& body = impl_->body(number);
  return {body.bullet->getInvMass() / mass_unit,
          from_bullet(body.bullet->getInvInertiaDiagLocal()) / mass_unit, body.shape.frame};
}

Pose RigidWorld::pose(uint32_t number) const {
  const RigidBodyRecord& body = impl_->body(number);
  if (body.kinematic) return body.memory.pose;
  return from_bullet(body.bullet->getWorldTransform()) * inverse(body.shape.frame);
}

Vec3 RigidWorld::velocity(uint32_t number) const {
  return from_bullet(impl_->body(number).bullet->getLinearVelocity());
}

Vec3 RigidWorld::angular_velocity(uint32_t number) const {
  return from_bullet(impl_->body(number).bullet->getAngularVelocity());
}

Vec3 RigidWorld::centre_of_mass(uint32_t number) const {
  return from_bullet(impl_->body(number).bullet->getCenterOfMassPosition());
}

bool RigidWorld::awake(uint32_t number) const {
  return impl_->body(number).bullet->isActive();
}

void RigidWorld::read_awake(std::vector<uint8_t>& out) const {
  out.resize(body_slots());
  for (uint32_t n = 0; n < out.size(); ++n) out[n] = !impl_->bodies.has(n) || awake(n);
}

void RigidWorld::set_pose(uint32_t number, const Pose& pose) {
  const InBullet bullet(*reserve_, impl_->size());
  RigidBodyRecord& body = impl_->body(number);
  btRigidBody* const placed = body.bullet.get();
  impl_->wake_around({&placed, 1});
  if (body.kinematic) {
    body.memory.drive = KinematicDrive::still;
    impl_->place_kinematic(body, pose);
    set_speed(*body.bullet, {0, 0, 0}, {0, 0, 0});
  } else {
    place(*body.bullet, to_bullet(pose) * to_bullet(body.shape.frame));
  }
  impl_->dynamics.updateSingleAabb(body.bullet.get());  // so that queries before the next step find it there
  collision::wake_up(*body.bullet);
}

void RigidWorld::set_velocity(uint32_t number, Vec3 velocity, Vec3 angular_velocity) {
  assert(!impl_->body(number).kinematic);
  set_speed(*impl_->body(number).bullet, velocity, angular_velocity);
  wake(number);
}

void RigidWorld::wake(uint32_t number) {
  wake_up(*impl_->body(number).bullet);
}

void RigidWorld::keep_awake(std::span<const uint32_t> bodies) {
  for (auto& body : impl_->bodies.slots) {
    if (body) body->kept_awake = false;
  }
  for (uint32_t n : bodies) {
    RigidBodyRecord& body = impl_->body(n);
    body.kept_awake = true;
    if (!body.bullet->isActive()) wake_up(*body.bullet);
  }
}

void RigidWorld::apply_force(uint32_t number, Vec3 force, Vec3 point) {
  RigidBodyRecord& body = impl_->body(number);
  body.memory.force += force;
  body.memory.torque += cross(point - from_bullet(body.bullet->getCenterOfMassPosition()), force);
  wake(number);
}

void RigidWorld::apply_torque(uint32_t number, Vec3 torque) {
  impl_->body(number).memory.torque += torque;
  wake(number);
}

RigidImpulse RigidWorld::pending(uint32_t number) const {
  const RigidBodyRecord& body = impl_->body(number);
  return {body.memory.force, body.memory.torque};
}

void RigidWorld::apply_impulse(uint32_t number, Vec3 impulse, Vec3 point) {
  btRigidBody& bullet = *impl_->body(number).bullet;
  bullet.applyImpulse(in_mass_units(impulse), to_bullet(point) - bullet.getCenterOfMassPosition());
  wake(number);
}

double RigidWorld::time() const {
  return impl_->time;
}

}  // namespace meniscus::collision
