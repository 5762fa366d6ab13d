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
MeniscusId either(BodyId body, ShapeId shape, ClothId cloth = {}) {
  if (is_valid(body)) return in_c(body);
  if (is_valid(shape)) return in_c(shape);
  return is_valid(cloth) ? in_c(cloth) : MeniscusId{};
}

void write_overlaps(MeniscusWorld& world, MeniscusOverlaps* out, const Overlaps& found) {
  world.overlap_solids.clear();
  for (const BodyId id : found.bodies) world.overlap_solids.push_back(in_c(id));
  for (const ShapeId id : found.shapes) world.overlap_solids.push_back(in_c(id));
  world.overlap_particles = found.particles;
  write_result(out, {0, world.overlap_solids.data(), world.overlap_solids.size(),
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

MeniscusStatus meniscus_cast_ray(const MeniscusWorld* world, MeniscusVec3 from, MeniscusVec3 to,
                                 MeniscusRayHit* hit) {
  return guarded([&] {
    const std::optional<RayHit> found = world_of(world).cast_ray(in_cpp(from), in_cpp(to));
    MeniscusRayHit result{};
    if (found)
      result = {0,
                1,
                either(found->body, found->shape),
                found->particle.value_or(0),
                in_c(found->point),
                in_c(found->normal),
                found->distance};
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
                                     MeniscusOverlaps* overlaps) {
  return guarded([&] {
    write_overlaps(required(world, "world"), overlaps, world_of(world).overlap_ball(in_cpp(centre), radius));
  });
}

MeniscusStatus meniscus_overlap_box(MeniscusWorld* world, MeniscusPose pose, MeniscusVec3 half_extents,
                                    MeniscusOverlaps* overlaps) {
  return guarded([&] {
    write_overlaps(required(world, "world"), overlaps,
                   world_of(world).overlap_box(in_cpp(pose), in_cpp(half_extents)));
  });
}
