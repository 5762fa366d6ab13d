// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Steps of a rigid world whose contacts a device solves (collision/rigid_contact/). Bullet keeps the bodies
// and answers rays.
#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "collision/rigid/rigid_impl.h"
#include "collision/rigid/tuning.h"

namespace meniscus::collision {

float yielding_of(const RigidMemory& memory) {
  if (memory.free_work == 0) return 1;
  return pbd::clamp(memory.push_work / memory.free_work, rigid_tuning::least_yielding, 1);
}

void refuse_joint() {
  throw Error(ErrorCode::invalid_argument,
              "RigidSolverDef::solver is device, which has no joints; bullet has them");
}

/// Small steps in one of `substeps` steps. Each visits all contacts twice.
int RigidWorld::Impl::small_steps() const {
  return (def.iterations + 1) / 2;
}

ContactBody RigidWorld::Impl::contact_body(const RigidBodyRecord& body, float h, bool pushed) const {
  const btRigidBody& b = *body.bullet;
  ContactBody to{from_bullet(b.getWorldTransform()),
                 from_bullet(b.getLinearVelocity()),
                 from_bullet(b.getAngularVelocity()),
                 0,
                 {0, 0, 0},
                 {0, 0, 0},
                 {0, 0, 0},
                 1,
                 1};
  if (body.kinematic || !b.isActive()) return to;
  to.inverse_mass = b.getInvMass() / mass_unit;
  to.inverse_inertia = from_bullet(b.getInvInertiaDiagLocal()) / mass_unit;
  to.acceleration = from_bullet(b.getGravity()) + to.inverse_mass * body.memory.force;
  to.torque = body.memory.torque;
  if (pushed) {
    to.acceleration += to.inverse_mass * body.push;
    to.torque += body.push_torque;
  }
  to.kept = std::pow(1 - b.getLinearDamping(), h);
  to.angular_kept = std::pow(1 - b.getAngularDamping(), h);
  return to;
}

void RigidWorld::Impl::arrive(RigidBodyRecord& body, const ContactMotion& motion) {
  btRigidBody& b = *body.bullet;
  b.setWorldTransform(to_bullet(motion.pose));
  b.setInterpolationWorldTransform(b.getWorldTransform());
  b.updateInertiaTensor();
  set_speed(b, motion.velocity, motion.angular);
}

void RigidWorld::Impl::gather_bodies(float dt, bool pushed) {
  contact_bodies.assign(bodies.slots.size(),
                        ContactBody{{}, {0, 0, 0}, {0, 0, 0}, 0, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1, 1});
  contact_motions.resize(bodies.slots.size());
  any_asleep = false;
  for_each_body([&](uint32_t n, const RigidBodyRecord& body) {
    any_asleep |= !body.kinematic && !body.bullet->isActive();
    contact_bodies[n] = contact_body(body, dt / static_cast<float>(small_steps()), pushed);
  });
}

/// Finds contacts, and wakes the sleeping bodies that are in them.
void RigidWorld::Impl::find_on_device(float dt, bool pushed) {
  do {
    gather_bodies(dt, pushed);
    contacts->find(contact_bodies, dt);
  } while (wake_touched());
}

ContactStep RigidWorld::Impl::contact_step(float dt) const {
  return {dt, small_steps(), rigid_tuning::resting_steps * dt * length(def.gravity)};
}

/// Finds contacts, and tries the first of `substeps` steps without the impulses of particles. So they meet
/// bodies where other solids let them be.
void RigidWorld::Impl::begin_on_device(float dt) {
  update_parts();
  wake_beside_driven();
  wake_islands();
  try_unpushed(dt);
}

void RigidWorld::Impl::try_unpushed(float dt) {
  find_on_device(dt, false);
  contacts->advance(contact_bodies, contact_step(dt), contact_motions);
  unpushed = contact_motions;
  tried_bodies = contact_bodies;
}

/// Whether the bodies are, bit for bit, those of try_unpushed(): then so is the step.
bool RigidWorld::Impl::is_tried() const {
  return tried_bodies.size() == contact_bodies.size() &&
         std::memcmp(tried_bodies.data(), contact_bodies.data(), tried_bodies.size() * sizeof(ContactBody)) ==
             0;
}

/// Where solids alone take a body that begin_on_device() tried, as a motion over `dt`.
RigidMotion RigidWorld::Impl::unpushed_motion(uint32_t number, const RigidBodyRecord& body, float dt) const {
  const Pose start = from_bullet(body.bullet->getWorldTransform());
  const ContactMotion& end = unpushed[number];
  if (!body.bullet->isActive()) return asleep(*body.bullet, body.memory, dt);
  const KinematicVelocity mean = velocity_to(start, end.pose, dt / static_cast<float>(def.substeps));
  if (!end.touches) return {start, mean.linear, mean.angular};
  return {start,
          mean.linear,
          mean.angular,
          normalized_or(body.memory.usual_force, {0, 0, 0}),
          yielding_of(body.memory),
          true};
}

/// Compares what the push of particles did to the body's velocity with what it would do to a free body, along
/// the usual push. The ratio is 1 for a free body, 0 for one that solids hold, and m/(M + m) for one of m
/// that bears M.
void RigidWorld::Impl::measure_yielding(RigidBodyRecord& body, uint32_t number, float dt) {
  const ContactBody& from = contact_bodies[number];
  const ContactMotion &end = contact_motions[number], &tried = unpushed[number];
  RigidMemory& memory = body.memory;
  const float kept = std::exp(-dt / rigid_tuning::yielding_time);
  const Vec3 along = normalized_or(memory.usual_force, {0, 0, 0});
  const float push = dot(body.push, along);
  const float weight = rigid_tuning::slight_push * acceleration_scale();
  // A slight push says little, and then the body counts as free.
  const float slight = from.inverse_mass > 0 ? dt * weight * weight / from.inverse_mass : 0;
  const float change = dot(end.velocity - tried.velocity, along);
  memory.push_work = kept * memory.push_work + slight + push * change;
  memory.free_work = kept * memory.free_work + slight + dt * from.inverse_mass * push * push;
}

/// One of `substeps` steps. begin_on_device() has found the contacts of the first.
void RigidWorld::Impl::step_on_device(float dt, bool is_first) {
  // A push may have woken some.
  if (is_first && wake_islands()) try_unpushed(dt);
  if (is_first)
    gather_bodies(dt, true);
  else
    find_on_device(dt, true);
  if (is_first && is_tried())
    contact_motions = unpushed;
  else
    contacts->advance(contact_bodies, contact_step(dt), contact_motions);
  contacts->accept();
  for (uint32_t n = 0; n < bodies.slots.size(); ++n) {
    if (!bodies.has(n) || bodies.slots[n]->kinematic || !bodies.slots[n]->bullet->isActive()) continue;
    if (is_first) measure_yielding(*bodies.slots[n], n, dt);
    arrive(*bodies.slots[n], contact_motions[n]);
  }
  boxes_changed = true;
  if (note_rest(dt)) fall_asleep();
}

/// Forces act in all small steps alike, so a body that falls gets further by half of the last one.
RigidMotion RigidWorld::Impl::flight_on_device(const RigidBodyRecord& body, float dt) const {
  const btRigidBody& b = *body.bullet;
  const ContactBody from = contact_body(body, 0.5f * dt, false);
  const float steps = static_cast<float>(small_steps() * def.substeps), mean = 0.5f * (1 + 1 / steps);
  const Vec3 spin = from_bullet(b.getInvInertiaTensorWorld() * in_mass_units(from.torque));
  const Vec3 free = from_bullet(tumbled(b, b.getAngularVelocity(), dt));
  return {from.pose, from.kept * from.velocity + mean * dt * from.acceleration,
          from.angular_kept * free + mean * dt * spin};
}

/// Bullet's boxes around solids, which rays need.
void RigidWorld::Impl::update_boxes() {
  if (!boxes_changed) return;
  dynamics.updateAabbs();
  boxes_changed = false;
}

std::vector<RigidContact> RigidWorld::Impl::contacts_on_device() const {
  std::vector<RigidContact> all;
  if (!contacts) return all;
  const auto add = [&](const SavedContact& c) {
    const RigidRef a = solid_of_key(c.key_a), b = solid_of_key(c.key_b);
    if (is_removed(a) || is_removed(b)) return;
    const bool turned = !a.is_body;  // a small fixed part may come before a large one of a body
    const Vec3 n = turned ? -c.normal : c.normal;
    all.push_back(
        {turned ? b : a, turned ? a : b, c.position - 0.5f * c.distance * n, n, c.distance, c.impulse});
  };
  std::ranges::for_each(contacts->save(), add);
  std::ranges::for_each(resting, add);
  return all;
}

/// The solids that touched. A pair may come more than once.
std::vector<RigidTouch> RigidWorld::Impl::touches_on_device() const {
  std::vector<RigidTouch> all;
  if (!contacts) return all;
  const auto add = [&](uint64_t key_a, uint64_t key_b) {
    const RigidRef a = solid_of_key(key_a), b = solid_of_key(key_b);
    if (!is_removed(a) && !is_removed(b)) all.push_back({a, b});
  };
  for (const TouchingParts& pair : contacts->touching()) add(pair.a, pair.b);
  for (const SavedContact& c : resting)
    if (c.distance <= 0 || c.impulse > 0) add(c.key_a, c.key_b);
  return all;
}

void RigidWorld::set_contacts(RigidContacts* contacts) {
  impl_->contacts = contacts;
  impl_->parts_changed = true;
}

bool RigidWorld::is_on_device() const {
  return impl_->def.on_device;
}

}  // namespace meniscus::collision
