// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The public calls of World that set state, each through the boundary.
#include "sdk/world/world_boundary.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

void World::set_positions(std::span<const Vec3> positions) {
  return impl_->run([&](auto w) { return w.set_positions(w.inward(positions)); });
}
void World::set_positions(FluidId fluid, std::span<const Vec3> positions) {
  return impl_->run([&](auto w) { return w.set_positions(fluid, w.inward(positions)); });
}
void World::set_positions(std::span<const ParticleId> ids, std::span<const Vec3> positions) {
  return impl_->run([&](auto w) { return w.set_positions(ids, w.inward(positions)); });
}
void World::set_velocities(std::span<const Vec3> velocities) {
  return impl_->run([&](auto w) { return w.set_velocities(velocities); });
}
void World::set_velocities(FluidId fluid, std::span<const Vec3> velocities) {
  return impl_->run([&](auto w) { return w.set_velocities(fluid, velocities); });
}
void World::set_velocities(std::span<const ParticleId> ids, std::span<const Vec3> velocities) {
  return impl_->run([&](auto w) { return w.set_velocities(ids, velocities); });
}
void World::set_cloth_positions(ClothId id, std::span<const Vec3> positions) {
  return impl_->run([&](auto w) { return w.set_cloth_positions(id, w.inward(positions)); });
}
void World::set_cloth_velocities(ClothId id, std::span<const Vec3> velocities) {
  return impl_->run([&](auto w) { return w.set_cloth_velocities(id, velocities); });
}
void World::set_rope_positions(RopeId id, std::span<const Vec3> positions) {
  return impl_->run([&](auto w) { return w.set_rope_positions(id, w.inward(positions)); });
}
void World::set_rope_velocities(RopeId id, std::span<const Vec3> velocities) {
  return impl_->run([&](auto w) { return w.set_rope_velocities(id, velocities); });
}
void World::set_shape_pose(ShapeId id, const Pose& pose) {
  return impl_->run([&](auto w) { return w.set_shape_pose(id, w.inward(pose)); });
}
void World::set_filter(FluidId id, const CollisionFilter& filter) {
  return impl_->run([&](auto w) { return w.set_filter(id, filter); });
}
void World::set_filter(ShapeId id, const CollisionFilter& filter) {
  return impl_->run([&](auto w) { return w.set_filter(id, filter); });
}
void World::set_filter(BodyId id, const CollisionFilter& filter) {
  return impl_->run([&](auto w) { return w.set_filter(id, filter); });
}
void World::set_filter(ClothId id, const CollisionFilter& filter) {
  return impl_->run([&](auto w) { return w.set_filter(id, filter); });
}
void World::set_filter(RopeId id, const CollisionFilter& filter) {
  return impl_->run([&](auto w) { return w.set_filter(id, filter); });
}
void World::set_surface(ShapeId id, const SurfaceDef& surface) {
  return impl_->run([&](auto w) { return w.set_surface(id, surface); });
}
void World::set_surface(BodyId id, const SurfaceDef& surface) {
  return impl_->run([&](auto w) { return w.set_surface(id, surface); });
}

}  // namespace meniscus
