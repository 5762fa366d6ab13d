// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The public calls of World that ask about contacts, events and places, each through the boundary.
#include "sdk/world/world_boundary.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

std::vector<ParticleContact> World::particle_contacts() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.outward(w.particle_contacts()); });
}
std::vector<SolidContact> World::solid_contacts() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.outward(w.solid_contacts()); });
}
const std::vector<ContactEvent>& World::contact_events() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.contact_events(); });
}
const std::vector<SleepEvent>& World::sleep_events() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.sleep_events(); });
}
const std::vector<FlowEvent>& World::flow_events() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.flow_events(); });
}
std::optional<RayHit> World::cast_ray(Vec3 from, Vec3 to, const QueryTargets& targets) const {
  return impl_->run([&](auto w) { return w.outward(w.cast_ray(w.inward(from), w.inward(to), targets)); });
}
std::optional<NearestPoint> World::nearest(Vec3 point, float reach, const QueryTargets& targets) const {
  return impl_->run([&](auto w) { return w.outward(w.nearest(w.inward(point), reach, targets)); });
}
std::vector<FluidSample> World::sample_fluid(std::span<const Vec3> points,
                                             std::optional<FluidId> fluid) const {
  return impl_->run([&](auto w) { return w.sample_fluid(w.inward(points), fluid); });
}
std::vector<float> World::solid_distances(std::span<const Vec3> points, float reach,
                                          const CollisionFilter& filter) const {
  return impl_->run(
      [&](auto w) -> decltype(auto) { return w.solid_distances(w.inward(points), reach, filter); });
}
Overlaps World::overlap_ball(Vec3 centre, float radius, const QueryTargets& targets) const {
  return impl_->run([&](auto w) { return w.overlap_ball(w.inward(centre), radius, targets); });
}
Overlaps World::overlap_box(const Pose& pose, Vec3 half_extents, const QueryTargets& targets) const {
  return impl_->run([&](auto w) { return w.overlap_box(w.inward(pose), half_extents, targets); });
}

}  // namespace meniscus
