// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: contacts, events and queries, as of the last step.
#pragma once

#include <meniscus/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// A particle that touches a body, a fixed shape or cloth.
typedef struct MeniscusParticleContact {
  uint64_t particle;     ///< its id
  MeniscusId other;      ///< a body, shape or cloth
  MeniscusVec3 point;    ///< m, on the surface
  MeniscusVec3 normal;   ///< unit, out of the solid, or off the cloth
  MeniscusVec3 impulse;  ///< N·s, on the particle
} MeniscusParticleContact;

/// Two solids that touch or are about to.
typedef struct MeniscusSolidContact {
  MeniscusId a;         ///< a body
  MeniscusId b;         ///< a body or a shape
  MeniscusVec3 point;   ///< m, on b
  MeniscusVec3 normal;  ///< unit, from b to a
  float distance;       ///< m, negative if they overlap
  float impulse;        ///< N·s along the normal, in the last step of Bullet
} MeniscusSolidContact;

/// Two solids that began or ceased to touch in the last step.
typedef struct MeniscusContactEvent {
  MeniscusId a;   ///< a body
  MeniscusId b;   ///< a body or a shape
  int32_t began;  ///< 1 if they began to touch, and 0 if they ceased
} MeniscusContactEvent;

/// The first hit of a ray.
typedef struct MeniscusRayHit {
  uint32_t size;        ///< of this struct
  int32_t is_hit;       ///< 0 if nothing was hit; the rest is then 0
  MeniscusId thing;     ///< a body, shape, cloth or rope; of kind MENISCUS_NONE for a particle
  uint64_t particle;    ///< if the ray hit a particle
  MeniscusVec3 point;   ///< m
  MeniscusVec3 normal;  ///< unit, against the ray
  float distance;       ///< m along the ray
  uint32_t element;     ///< of cloth the triangle, of a rope the segment; by number
} MeniscusRayHit;

/// The nearest place on a surface: meniscus::NearestPoint.
typedef struct MeniscusNearestPoint {
  uint32_t size;        ///< of this struct
  int32_t is_there;     ///< 0 if nothing is in reach; the rest is then 0
  MeniscusId thing;     ///< a body, shape, cloth or rope; of kind MENISCUS_NONE for a particle
  uint32_t element;     ///< of cloth the triangle, of a rope the segment; by number
  uint64_t particle;    ///< if it is a particle
  MeniscusVec3 point;   ///< m, on the surface
  MeniscusVec3 normal;  ///< unit, out of the surface; of cloth towards the given point
  float distance;       ///< m, from the given point; negative inside
} MeniscusNearestPoint;

/// The fluid at a point: meniscus::FluidSample.
typedef struct MeniscusFluidSample {
  float density;          ///< kg/m³
  MeniscusVec3 velocity;  ///< m/s
  uint32_t particles;     ///< within the support radius
} MeniscusFluidSample;

/// A body that fell asleep or woke.
typedef struct MeniscusSleepEvent {
  MeniscusId body;  ///< the body
  int32_t awake;    ///< 1 if it woke, and 0 if it fell asleep
} MeniscusSleepEvent;

/// A particle that came or went.
typedef struct MeniscusFlowEvent {
  MeniscusId by;      ///< the emitter that made it, or the sink that removed it
  uint64_t particle;  ///< its id
} MeniscusFlowEvent;

/// What a query considers, as a sum.
typedef enum MeniscusTargets MENISCUS_ANY_INT {
  MENISCUS_SOLIDS = 1,
  MENISCUS_PARTICLES = 2,
  MENISCUS_CLOTHS = 4,
  MENISCUS_ROPES = 8,
  MENISCUS_ALL = 15
} MeniscusTargets;

/// What a volume overlaps. Arrays are valid until the next overlap call.
typedef struct MeniscusOverlaps {
  uint32_t size;              ///< of this struct
  const MeniscusId* things;   ///< bodies, then shapes, cloth and ropes
  size_t thing_count;         ///< number of things
  const uint64_t* particles;  ///< those with their centres inside
  size_t particle_count;      ///< number of particles
} MeniscusOverlaps;

/// Contacts of particles that have an impulse.
MENISCUS_C_API MeniscusStatus meniscus_particle_contacts(MeniscusWorld* world,
                                                         const MeniscusParticleContact** contacts,
                                                         size_t* count);
/// Contacts of solids. At least one of each pair is a body.
MENISCUS_C_API MeniscusStatus meniscus_solid_contacts(MeniscusWorld* world,
                                                      const MeniscusSolidContact** contacts, size_t* count);
/// Pairs of solids that began or ceased to touch in the last step.
MENISCUS_C_API MeniscusStatus meniscus_contact_events(MeniscusWorld* world,
                                                      const MeniscusContactEvent** events, size_t* count);
/// Bodies that fell asleep or woke in the last step.
MENISCUS_C_API MeniscusStatus meniscus_sleep_events(MeniscusWorld* world, const MeniscusSleepEvent** events,
                                                    size_t* count);
/// Particles that sinks removed and emitters made in the last step.
MENISCUS_C_API MeniscusStatus meniscus_flow_events(MeniscusWorld* world, const MeniscusFlowEvent** events,
                                                   size_t* count);
/// The first thing between two points, m: World::cast_ray. `targets` is a sum of MeniscusTargets.
MENISCUS_C_API MeniscusStatus meniscus_cast_ray(const MeniscusWorld* world, MeniscusVec3 from,
                                                MeniscusVec3 to, uint32_t targets, MeniscusRayHit* hit);
/// The nearest place on a surface within `reach`, m: World::nearest.
MENISCUS_C_API MeniscusStatus meniscus_nearest(const MeniscusWorld* world, MeniscusVec3 point, float reach,
                                               uint32_t targets, MeniscusNearestPoint* place);
/// Density and velocity at points: World::sample_fluid. `fluid` may be null: then all count. `samples` has
/// room for `count` of them.
MENISCUS_C_API MeniscusStatus meniscus_sample_fluid(const MeniscusWorld* world, const MeniscusVec3* points,
                                                    size_t count, const MeniscusId* fluid,
                                                    MeniscusFluidSample* samples);
/// m, from each point to the surface of the nearest solid that the filter collides with, negative inside. It
/// is `reach` if no solid is nearer. `filter` may be null: then all solids count. `distances` has room for
/// `count` numbers.
MENISCUS_C_API MeniscusStatus meniscus_solid_distances(const MeniscusWorld* world, const MeniscusVec3* points,
                                                       size_t count, float reach,
                                                       const MeniscusFilter* filter, float* distances);
/// What a ball overlaps; m.
MENISCUS_C_API MeniscusStatus meniscus_overlap_ball(MeniscusWorld* world, MeniscusVec3 centre, float radius,
                                                    uint32_t targets, MeniscusOverlaps* overlaps);
/// What a box overlaps; m.
MENISCUS_C_API MeniscusStatus meniscus_overlap_box(MeniscusWorld* world, MeniscusPose pose,
                                                   MeniscusVec3 half_extents, uint32_t targets,
                                                   MeniscusOverlaps* overlaps);

#ifdef __cplusplus
}
#endif
