// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: state that is set from outside. Read-outs show it at once, and the next step starts from it. World
// in meniscus/world.h says what each call does to warm starts, lists and sleep.
#pragma once

#include <meniscus/c/defs.h>
#include <meniscus/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// m, of all particles, in the order of their ids. `count` must be their number. Velocities stay.
MENISCUS_C_API MeniscusStatus meniscus_set_positions(MeniscusWorld* world, const MeniscusVec3* positions,
                                                     size_t count);
/// m/s, likewise.
MENISCUS_C_API MeniscusStatus meniscus_set_velocities(MeniscusWorld* world, const MeniscusVec3* velocities,
                                                      size_t count);
/// m, of the particles of one fluid or granular material.
MENISCUS_C_API MeniscusStatus meniscus_set_fluid_positions(MeniscusWorld* world, MeniscusId fluid,
                                                           const MeniscusVec3* positions, size_t count);
/// m/s, likewise.
MENISCUS_C_API MeniscusStatus meniscus_set_fluid_velocities(MeniscusWorld* world, MeniscusId fluid,
                                                            const MeniscusVec3* velocities, size_t count);
/// m, of these particles, in any order. An unknown or repeated id is an error.
MENISCUS_C_API MeniscusStatus meniscus_set_particle_positions(MeniscusWorld* world, const uint64_t* ids,
                                                              const MeniscusVec3* positions, size_t count);
/// m/s, likewise.
MENISCUS_C_API MeniscusStatus meniscus_set_particle_velocities(MeniscusWorld* world, const uint64_t* ids,
                                                               const MeniscusVec3* velocities, size_t count);
/// m, of all vertices of a piece of cloth, a rope or a rod.
MENISCUS_C_API MeniscusStatus meniscus_set_vertex_positions(MeniscusWorld* world, MeniscusId cloth_or_rope,
                                                            const MeniscusVec3* positions, size_t count);
/// m/s, likewise.
MENISCUS_C_API MeniscusStatus meniscus_set_vertex_velocities(MeniscusWorld* world, MeniscusId cloth_or_rope,
                                                             const MeniscusVec3* velocities, size_t count);
/// Places a shape. Bodies that touched it wake.
MENISCUS_C_API MeniscusStatus meniscus_set_shape_pose(MeniscusWorld* world, MeniscusId shape,
                                                      MeniscusPose pose);
/// The collision filter of a fluid or granular material, a shape, a body, a piece of cloth or a rope.
MENISCUS_C_API MeniscusStatus meniscus_set_filter(MeniscusWorld* world, MeniscusId thing,
                                                  MeniscusFilter filter);
/// Gives a shape or a body the surface of a definition of its kind. The rest of the definition has no effect.
MENISCUS_C_API MeniscusStatus meniscus_set_surface(MeniscusWorld* world, MeniscusId shape_or_body,
                                                   const MeniscusDef* def);

#ifdef __cplusplus
}
#endif
