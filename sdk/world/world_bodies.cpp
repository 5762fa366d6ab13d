// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's calls about rigid bodies and joints.
#include <meniscus/error.h>
#include <meniscus/world.h>

#include <algorithm>
#include <sstream>

#include "sdk/world/check/check.h"
#include "sdk/world/check/periodic.h"
#include "sdk/world/state/body_calls.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

collision::MassProperties mass_of(const BodyDef& def, const SolidPieces& solid) {
  if (def.motion == BodyMotion::kinematic) return {};
  const collision::MassProperties by_density = collision::combine(solid.masses);
  const collision::MassProperties mass =
      def.mass ? collision::with_mass(by_density, double{*def.mass}) : by_density;
  // Floats can represent these masses, the moments of inertia, and the inverses of both.
  if (!(mass.mass >= 1e-20 && mass.mass <= 1e20)) {
    std::ostringstream value;
    value << (def.mass ? double{*def.mass} : double{def.density});
    check::refuse(def.mass ? "BodyDef::mass" : "BodyDef::density", value.str(),
                  "such that the body has from 1e-20 to 1e20 kg");
  }
  return mass;
}

collision::RigidBodyDef rigid_def(const BodyDef& def, const SolidPieces& solid,
                                  const collision::MassProperties& mass) {
  collision::RigidBodyDef rigid;
  rigid.solid = rigid_solid(solid, def.pose, def.surface, def.filter);
  rigid.motion = def.motion;
  rigid.mass = mass;
  rigid.velocity = def.velocity;
  rigid.angular_velocity = def.angular_velocity;
  rigid.linear_damping = def.linear_damping;
  rigid.angular_damping = def.angular_damping;
  rigid.can_sleep = def.can_sleep;
  rigid.keyframes = def.keyframes;
  rigid.loop = def.loop;
  rigid.name = def.name;
  return rigid;
}

}  // namespace

BodyId World::Calls::create_body(const BodyDef& def) {
  check::def(def);
  check::no_periodic_axes(impl_->def, "bodies");
  impl_->bodies.prepare();
  BodyEntry entry = impl_->make_body(def, {});
  impl_->solids_changed();
  impl_->note_repairs(entry.solid);
  const BodyId id = impl_->bodies.insert(std::move(entry));
  if (id.index < impl_->awake.size()) impl_->awake[id.index] = 1;
  return id;
}

/// Adds the body to the rigid world.
BodyEntry World::Impl::make_body(const BodyDef& body, const collision::RigidPlace& place) {
  const bool dynamic = body.motion == BodyMotion::dynamic;
  BodyEntry entry;
  entry.def = body;
  {
    const pbd::CallMonitor::Cancellable undone_within(monitor());
    entry.solid =
        make_solid(body.geometry, body.surface, body.filter,
                   dynamic ? SolidRole::dynamic : SolidRole::kinematic, body.density, solid_context());
  }
  double volume = 0;
  for (const collision::PlacedMass& part : entry.solid.masses)
    volume += part.body.mass / double{body.density};
  const collision::MassProperties mass = mass_of(body, entry.solid);
  entry.mass = {static_cast<float>(mass.mass), static_cast<float>(volume), mass.centre, mass.inertia,
                mass.axes};
  const uint32_t number = rigid.add_body(rigid_def(body, entry.solid, mass), place);  // the last to fail
  entry.principal = rigid.mass(number).principal;
  return entry;
}

collision::RigidBodyDef rigid_body(const BodyEntry& body) {
  return rigid_def(body.def, body.solid, mass_of(body.def, body.solid));
}

void World::Impl::note_repairs(const SolidPieces& solid) {
  mesh_repairs.insert(mesh_repairs.end(), solid.repairs.begin(), solid.repairs.end());
  if (!log.is_read()) return;
  for (const MeshRepair& r : solid.repairs)
    log.note("the surface of " + r.file + " was rebuilt, within " + std::to_string(r.deviation) + " m");
}

const std::vector<MeshRepair>& World::Calls::mesh_repairs() const {
  return impl_->mesh_repairs;
}

void World::Calls::destroy_body(BodyId id) {
  impl_->bodies.get(id);
  const std::vector<uint32_t> its_joints = impl_->rigid.joints_of(id.index);
  impl_->drop_attachments_of(id);  // reads from the device, and may fail
  impl_->forget_solid({true, id.index});
  impl_->monitor().commit();
  impl_->drop_flow_of(id);
  impl_->solids_changed();
  for (const uint32_t joint : its_joints) {
    impl_->rigid.remove_joint(joint);
    impl_->joints.erase(impl_->joints.id(joint));
  }
  impl_->bodies.erase(id);
}

collision::RigidJointDef rigid_joint(const JointDef& def) {
  return {def.a.index, def.b ? def.b->index : pbd::no_index, def.frame, def.kind, def.bodies_collide};
}

JointId World::Calls::create_joint(const JointDef& def) {
  check::def(def);
  impl_->bodies.get(def.a);
  if (def.b) impl_->bodies.get(*def.b);
  impl_->joints.prepare();
  impl_->rigid.add_joint(rigid_joint(def));
  impl_->note_revision();
  return impl_->joints.insert(def);
}

void World::Calls::destroy_joint(JointId id) {
  impl_->joints.get(id);
  impl_->rigid.remove_joint(id.index);
  impl_->note_revision();
  impl_->joints.erase(id);
}

// ---- state ----

BodyCalls World::Impl::calls_of(BodyId id) {
  return {bodies.get(id), rigid, id.index};
}

BodyState World::Calls::body_state(BodyId id) const {
  const BodyCalls body = impl_->calls_of(id);
  const std::span<const collision::RigidImpulse> forces = impl_->engine->body_forces();
  return body.state(id.index < forces.size()
                        ? forces[id.index]
                        : collision::RigidImpulse{});  // the body was created since the step
}

BodyMass World::Calls::body_mass(BodyId id) const {
  return impl_->bodies.get(id).mass;
}

double World::Calls::hinge_angle(JointId id) const {
  if (!std::holds_alternative<HingeJoint>(impl_->joints.get(id).kind))
    throw Error(ErrorCode::invalid_argument, "hinge_angle is for hinges alone");
  return impl_->rigid.hinge_angle(id.index);
}

void World::Calls::set_body_pose(BodyId id, const Pose& pose) {
  impl_->bodies.get(id);
  check::value("set_body_pose's pose", pose);
  impl_->monitor().commit();
  impl_->rigid.set_pose(id.index, pose);
  if (impl_->solids_are_on_device) impl_->engine->place_bodies();  // otherwise when they are uploaded
  impl_->state_changed();
}

void World::Calls::set_body_velocity(BodyId id, Vec3 velocity, Vec3 angular_velocity) {
  impl_->calls_of(id).set_velocity(velocity, angular_velocity);
}

void World::Calls::apply_force(BodyId id, Vec3 force, Vec3 point) {
  impl_->calls_of(id).apply_force(force, point);
}

void World::Calls::apply_force(BodyId id, Vec3 force) {
  impl_->bodies.get(id);
  apply_force(id, force, impl_->rigid.centre_of_mass(id.index));
}

void World::Calls::apply_torque(BodyId id, Vec3 torque) {
  impl_->calls_of(id).apply_torque(torque);
}

void World::Calls::apply_impulse(BodyId id, Vec3 impulse, Vec3 point) {
  impl_->calls_of(id).apply_impulse(impulse, point);
}

void World::Calls::move_body(BodyId id, const Pose& target, float duration) {
  impl_->calls_of(id).move(target, duration);
}

}  // namespace meniscus
