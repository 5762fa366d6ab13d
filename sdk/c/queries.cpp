// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts, events and queries of C.
#include <meniscus/c/queries.h>

#include <algorithm>
#include <span>

#include "sdk/c/handles.h"

namespace meniscus::c {
namespace {

template <class IdType>
bool is_valid(IdType id) {
  return !(id == IdType{});
}

/// The id that is valid, or that of nothing.
MeniscusId either(BodyId body, ShapeId shape, ClothId cloth = {}, RopeId rope = {}) {
  if (is_valid(body)) return in_c(body);
  if (is_valid(shape)) return in_c(shape);
  if (is_valid(cloth)) return in_c(cloth);
  return is_valid(rope) ? in_c(rope) : MeniscusId{};
}

QueryTargets targets_of(uint32_t targets) {
  if (targets & ~uint32_t{MENISCUS_ALL})
    throw Error(ErrorCode::invalid_argument,
                "targets is " + std::to_string(targets) + "; it must be at most 15");
  return {(targets & MENISCUS_SOLIDS) != 0, (targets & MENISCUS_PARTICLES) != 0,
          (targets & MENISCUS_CLOTHS) != 0, (targets & MENISCUS_ROPES) != 0};
}

void write_overlaps(MeniscusWorld& world, MeniscusOverlaps* out, const Overlaps& found) {
  world.overlap_things.clear();
  for (const BodyId id : found.bodies) world.overlap_things.push_back(in_c(id));
  for (const ShapeId id : found.shapes) world.overlap_things.push_back(in_c(id));
  for (const ClothId id : found.cloths) world.overlap_things.push_back(in_c(id));
  for (const RopeId id : found.ropes) world.overlap_things.push_back(in_c(id));
  world.overlap_particles = found.particles;
  write_result(out, {0, world.overlap_things.data(), world.overlap_things.size(),
                     world.overlap_particles.data(), world.overlap_particles.size()});
}

}  // namespace
}  // namespace meniscus::c

using namespace meniscus::c;
using namespace meniscus;

MeniscusStatus meniscus_particle_contacts(MeniscusWorld* world, const MeniscusParticleContact** contacts,
                                          size_t* count) {
  return guarded([&] {
    std::vector<MeniscusParticleContact>& list = required(world, "world").particle_contacts;
    list.clear();
    for (const ParticleContact& c : world->world.particle_contacts())
      list.push_back(
          {c.particle, either(c.body, c.shape, c.cloth), in_c(c.point), in_c(c.normal), in_c(c.impulse)});
    write_array(contacts, count, list);
  });
}

MeniscusStatus meniscus_solid_contacts(MeniscusWorld* world, const MeniscusSolidContact** contacts,
                                       size_t* count) {
  return guarded([&] {
    std::vector<MeniscusSolidContact>& list = required(world, "world").solid_contacts;
    list.clear();
    for (const SolidContact& c : world->world.solid_contacts())
      list.push_back({in_c(c.a), either(c.b, c.shape), in_c(c.point), in_c(c.normal), c.distance, c.impulse});
    write_array(contacts, count, list);
  });
}

MeniscusStatus meniscus_contact_events(MeniscusWorld* world, const MeniscusContactEvent** events,
                                       size_t* count) {
  return guarded([&] {
    std::vector<MeniscusContactEvent>& list = required(world, "world").contact_events;
    list.clear();
    for (const ContactEvent& e : world->world.contact_events())
      list.push_back({in_c(e.a), either(e.b, e.shape), e.began ? 1 : 0});
    write_array(events, count, list);
  });
}

MeniscusStatus meniscus_sleep_events(MeniscusWorld* world, const MeniscusSleepEvent** events, size_t* count) {
  return guarded([&] {
    std::vector<MeniscusSleepEvent>& list = required(world, "world").sleep_events;
    list.clear();
    for (const SleepEvent& e : world->world.sleep_events()) list.push_back({in_c(e.body), e.awake ? 1 : 0});
    write_array(events, count, list);
  });
}

MeniscusStatus meniscus_flow_events(MeniscusWorld* world, const MeniscusFlowEvent** events, size_t* count) {
  return guarded([&] {
    std::vector<MeniscusFlowEvent>& list = required(world, "world").flow_events;
    list.clear();
    for (const FlowEvent& e : world->world.flow_events())
      list.push_back({is_valid(e.emitter) ? in_c(e.emitter) : in_c(e.sink), e.particle});
    write_array(events, count, list);
  });
}

MeniscusStatus meniscus_nearest(const MeniscusWorld* world, MeniscusVec3 point, float reach, uint32_t targets,
                                MeniscusNearestPoint* place) {
  return guarded([&] {
    const auto found = world_of(world).nearest(in_cpp(point), reach, targets_of(targets));
    MeniscusNearestPoint result{};
    if (found)
      result = {0,
                1,
                either(found->body, found->shape, found->cloth, found->rope),
                found->element,
                found->particle.value_or(0),
                in_c(found->point),
                in_c(found->normal),
                found->distance};
    write_result(place, result);
  });
}

MeniscusStatus meniscus_sample_fluid(const MeniscusWorld* world, const MeniscusVec3* points, size_t count,
                                     const MeniscusId* fluid, MeniscusFluidSample* samples) {
  return guarded([&] {
    const std::span<const Vec3> at(same_layout<Vec3>(required_array(points, count, "points")), count);
    MeniscusFluidSample* out = required_array(samples, count, "samples");
    std::optional<FluidId> of;
    if (fluid) of = in_cpp<FluidId>(*fluid);
    for (const FluidSample& s : world_of(world).sample_fluid(at, of))
      *out++ = {s.density, in_c(s.velocity), s.particles};
  });
}

MeniscusStatus meniscus_cast_ray(const MeniscusWorld* world, MeniscusVec3 from, MeniscusVec3 to,
                                 uint32_t targets, MeniscusRayHit* hit) {
  return guarded([&] {
    const std::optional<RayHit> found =
        world_of(world).cast_ray(in_cpp(from), in_cpp(to), targets_of(targets));
    MeniscusRayHit result{};
    if (found)
      result = {0,
                1,
                either(found->body, found->shape, found->cloth, found->rope),
                found->particle.value_or(0),
                in_c(found->point),
                in_c(found->normal),
                found->distance,
                found->element};
    write_result(hit, result);
  });
}

MeniscusStatus meniscus_solid_distances(const MeniscusWorld* world, const MeniscusVec3* points, size_t count,
                                        float reach, const MeniscusFilter* filter, float* distances) {
  return guarded([&] {
    const CollisionFilter with = filter ? CollisionFilter{filter->groups, filter->mask} : CollisionFilter{};
    const std::span<const Vec3> at(same_layout<Vec3>(required_array(points, count, "points")), count);
    float* const out = required_array(distances, count, "distances");
    const std::vector<float> found = world_of(world).solid_distances(at, reach, with);
    std::copy(found.begin(), found.end(), out);
  });
}

MeniscusStatus meniscus_overlap_ball(MeniscusWorld* world, MeniscusVec3 centre, float radius,
                                     uint32_t targets, MeniscusOverlaps* overlaps) {
  return guarded([&] {
    write_overlaps(required(world, "world"), overlaps,
                   world_of(world).overlap_ball(in_cpp(centre), radius, targets_of(targets)));
  });
}

MeniscusStatus meniscus_overlap_box(MeniscusWorld* world, MeniscusPose pose, MeniscusVec3 half_extents,
                                    uint32_t targets, MeniscusOverlaps* overlaps) {
  return guarded([&] {
    write_overlaps(required(world, "world"), overlaps,
                   world_of(world).overlap_box(in_cpp(pose), in_cpp(half_extents), targets_of(targets)));
  });
}
