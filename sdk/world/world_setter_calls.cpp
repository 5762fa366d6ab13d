// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The public calls of World that set state or push, each through the boundary.
#include "sdk/world/world_boundary.h"
#include "sdk/world/world_calls.h"
#include "sdk/world/world_recorded.h"

namespace meniscus {

void World::set_positions(std::span<const Vec3> positions) {
  return impl_->recorded(
      "set_positions", [&](auto w) { return w.set_positions(w.inward(positions)); }, positions);
}
void World::set_positions(FluidId fluid, std::span<const Vec3> positions) {
  return impl_->recorded(
      "set_fluid_positions", [&](auto w) { return w.set_positions(fluid, w.inward(positions)); }, fluid,
      positions);
}
void World::set_positions(std::span<const ParticleId> ids, std::span<const Vec3> positions) {
  return impl_->recorded(
      "set_particle_positions", [&](auto w) { return w.set_positions(ids, w.inward(positions)); }, ids,
      positions);
}
void World::set_velocities(std::span<const Vec3> velocities) {
  return impl_->recorded(
      "set_velocities", [&](auto w) { return w.set_velocities(velocities); }, velocities);
}
void World::set_velocities(FluidId fluid, std::span<const Vec3> velocities) {
  return impl_->recorded(
      "set_fluid_velocities", [&](auto w) { return w.set_velocities(fluid, velocities); }, fluid, velocities);
}
void World::set_velocities(std::span<const ParticleId> ids, std::span<const Vec3> velocities) {
  return impl_->recorded(
      "set_particle_velocities", [&](auto w) { return w.set_velocities(ids, velocities); }, ids, velocities);
}
void World::set_cloth_positions(ClothId id, std::span<const Vec3> positions) {
  return impl_->recorded(
      "set_cloth_positions", [&](auto w) { return w.set_cloth_positions(id, w.inward(positions)); }, id,
      positions);
}
void World::set_cloth_velocities(ClothId id, std::span<const Vec3> velocities) {
  return impl_->recorded(
      "set_cloth_velocities", [&](auto w) { return w.set_cloth_velocities(id, velocities); }, id, velocities);
}
void World::set_rope_positions(RopeId id, std::span<const Vec3> positions) {
  return impl_->recorded(
      "set_rope_positions", [&](auto w) { return w.set_rope_positions(id, w.inward(positions)); }, id,
      positions);
}
void World::set_rope_velocities(RopeId id, std::span<const Vec3> velocities) {
  return impl_->recorded(
      "set_rope_velocities", [&](auto w) { return w.set_rope_velocities(id, velocities); }, id, velocities);
}
void World::set_shape_pose(ShapeId id, const Pose& pose) {
  return impl_->recorded(
      "set_shape_pose", [&](auto w) { return w.set_shape_pose(id, w.inward(pose)); }, id, pose);
}
void World::set_filter(FluidId id, const CollisionFilter& filter) {
  return impl_->recorded(
      "set_fluid_filter", [&](auto w) { return w.set_filter(id, filter); }, id, filter);
}
void World::set_filter(ShapeId id, const CollisionFilter& filter) {
  return impl_->recorded(
      "set_shape_filter", [&](auto w) { return w.set_filter(id, filter); }, id, filter);
}
void World::set_filter(BodyId id, const CollisionFilter& filter) {
  return impl_->recorded(
      "set_body_filter", [&](auto w) { return w.set_filter(id, filter); }, id, filter);
}
void World::set_filter(ClothId id, const CollisionFilter& filter) {
  return impl_->recorded(
      "set_cloth_filter", [&](auto w) { return w.set_filter(id, filter); }, id, filter);
}
void World::set_filter(RopeId id, const CollisionFilter& filter) {
  return impl_->recorded(
      "set_rope_filter", [&](auto w) { return w.set_filter(id, filter); }, id, filter);
}
void World::set_surface(ShapeId id, const SurfaceDef& surface) {
  return impl_->recorded(
      "set_shape_surface", [&](auto w) { return w.set_surface(id, surface); }, id, surface);
}
void World::set_surface(BodyId id, const SurfaceDef& surface) {
  return impl_->recorded(
      "set_body_surface", [&](auto w) { return w.set_surface(id, surface); }, id, surface);
}
void World::set_body_pose(BodyId id, const Pose& pose) {
  return impl_->recorded(
      "set_body_pose", [&](auto w) { return w.set_body_pose(id, w.inward(pose)); }, id, pose);
}
void World::set_body_velocity(BodyId id, Vec3 velocity, Vec3 angular_velocity) {
  return impl_->recorded(
      "set_body_velocity", [&](auto w) { return w.set_body_velocity(id, velocity, angular_velocity); }, id,
      velocity, angular_velocity);
}
void World::apply_force(BodyId id, Vec3 force, Vec3 point) {
  return impl_->recorded(
      "apply_force", [&](auto w) { return w.apply_force(id, force, w.inward(point)); }, id, force, point);
}
void World::apply_force(BodyId id, Vec3 force) {
  return impl_->recorded(
      "apply_central_force", [&](auto w) { return w.apply_force(id, force); }, id, force);
}
void World::apply_torque(BodyId id, Vec3 torque) {
  return impl_->recorded(
      "apply_torque", [&](auto w) { return w.apply_torque(id, torque); }, id, torque);
}
void World::apply_impulse(BodyId id, Vec3 impulse, Vec3 point) {
  return impl_->recorded(
      "apply_impulse", [&](auto w) { return w.apply_impulse(id, impulse, w.inward(point)); }, id, impulse,
      point);
}
void World::move_body(BodyId id, const Pose& target, float duration) {
  return impl_->recorded(
      "move_body", [&](auto w) { return w.move_body(id, w.inward(target), duration); }, id, target, duration);
}
void World::apply_impulses(std::span<const ParticleId> ids, std::span<const Vec3> impulses) {
  return impl_->recorded(
      "apply_particle_impulses", [&](auto w) { return w.apply_impulses(ids, impulses); }, ids, impulses);
}
void World::apply_impulses(ClothId id, std::span<const uint32_t> vertices, std::span<const Vec3> impulses) {
  return impl_->recorded(
      "apply_cloth_impulses", [&](auto w) { return w.apply_impulses(id, vertices, impulses); }, id, vertices,
      impulses);
}
void World::apply_impulses(RopeId id, std::span<const uint32_t> vertices, std::span<const Vec3> impulses) {
  return impl_->recorded(
      "apply_rope_impulses", [&](auto w) { return w.apply_impulses(id, vertices, impulses); }, id, vertices,
      impulses);
}

}  // namespace meniscus
