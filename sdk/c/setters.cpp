// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// State that C sets from outside.
#include <meniscus/c/setters.h>

#include "sdk/c/handles.h"

using namespace meniscus::c;
using namespace meniscus;

namespace {

std::span<const Vec3> vectors(const MeniscusVec3* values, size_t count, const char* name) {
  return {same_layout<Vec3>(required_array(values, count, name)), count};
}

std::span<const ParticleId> particles(const uint64_t* ids, size_t count) {
  return {required_array(ids, count, "ids"), count};
}

}  // namespace

MeniscusStatus meniscus_set_positions(MeniscusWorld* world, const MeniscusVec3* positions, size_t count) {
  return guarded([&] { world_of(world).set_positions(vectors(positions, count, "positions")); });
}

MeniscusStatus meniscus_set_velocities(MeniscusWorld* world, const MeniscusVec3* velocities, size_t count) {
  return guarded([&] { world_of(world).set_velocities(vectors(velocities, count, "velocities")); });
}

MeniscusStatus meniscus_set_fluid_positions(MeniscusWorld* world, MeniscusId fluid,
                                            const MeniscusVec3* positions, size_t count) {
  return guarded(
      [&] { world_of(world).set_positions(in_cpp<FluidId>(fluid), vectors(positions, count, "positions")); });
}

MeniscusStatus meniscus_set_fluid_velocities(MeniscusWorld* world, MeniscusId fluid,
                                             const MeniscusVec3* velocities, size_t count) {
  return guarded([&] {
    world_of(world).set_velocities(in_cpp<FluidId>(fluid), vectors(velocities, count, "velocities"));
  });
}

MeniscusStatus meniscus_set_particle_positions(MeniscusWorld* world, const uint64_t* ids,
                                               const MeniscusVec3* positions, size_t count) {
  return guarded(
      [&] { world_of(world).set_positions(particles(ids, count), vectors(positions, count, "positions")); });
}

MeniscusStatus meniscus_set_particle_velocities(MeniscusWorld* world, const uint64_t* ids,
                                                const MeniscusVec3* velocities, size_t count) {
  return guarded([&] {
    world_of(world).set_velocities(particles(ids, count), vectors(velocities, count, "velocities"));
  });
}

MeniscusStatus meniscus_set_vertex_positions(MeniscusWorld* world, MeniscusId cloth_or_rope,
                                             const MeniscusVec3* positions, size_t count) {
  return guarded([&] {
    const std::span<const Vec3> to = vectors(positions, count, "positions");
    if (cloth_or_rope.kind == MENISCUS_ROPE)
      world_of(world).set_rope_positions(in_cpp<RopeId>(cloth_or_rope), to);
    else
      world_of(world).set_cloth_positions(in_cpp<ClothId>(cloth_or_rope), to);
  });
}

MeniscusStatus meniscus_set_vertex_velocities(MeniscusWorld* world, MeniscusId cloth_or_rope,
                                              const MeniscusVec3* velocities, size_t count) {
  return guarded([&] {
    const std::span<const Vec3> to = vectors(velocities, count, "velocities");
    if (cloth_or_rope.kind == MENISCUS_ROPE)
      world_of(world).set_rope_velocities(in_cpp<RopeId>(cloth_or_rope), to);
    else
      world_of(world).set_cloth_velocities(in_cpp<ClothId>(cloth_or_rope), to);
  });
}

MeniscusStatus meniscus_set_shape_pose(MeniscusWorld* world, MeniscusId shape, MeniscusPose pose) {
  return guarded([&] { world_of(world).set_shape_pose(in_cpp<ShapeId>(shape), in_cpp(pose)); });
}

MeniscusStatus meniscus_set_filter(MeniscusWorld* world, MeniscusId thing, MeniscusFilter filter_in_c) {
  return guarded([&] {
    World& w = world_of(world);
    const CollisionFilter filter{filter_in_c.groups, filter_in_c.mask};
    switch (thing.kind) {
      case MENISCUS_FLUID:
        return w.set_filter(in_cpp<FluidId>(thing), filter);
      case MENISCUS_BODY:
        return w.set_filter(in_cpp<BodyId>(thing), filter);
      case MENISCUS_CLOTH:
        return w.set_filter(in_cpp<ClothId>(thing), filter);
      case MENISCUS_ROPE:
        return w.set_filter(in_cpp<RopeId>(thing), filter);
      default:
        return w.set_filter(in_cpp<ShapeId>(thing), filter);
    }
  });
}

MeniscusStatus meniscus_set_surface(MeniscusWorld* world, MeniscusId shape_or_body, const MeniscusDef* def) {
  return guarded([&] {
    if (shape_or_body.kind == MENISCUS_BODY)
      world_of(world).set_surface(in_cpp<BodyId>(shape_or_body), def_of<BodyDef>(def).surface);
    else
      world_of(world).set_surface(in_cpp<ShapeId>(shape_or_body), def_of<ShapeDef>(def).surface);
  });
}
