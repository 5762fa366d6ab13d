// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: read-outs of particles, one element a particle in the order of the ids.
#pragma once

#include <meniscus/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// A tensor of DLPack, as dlpack.h declares it.
struct DLManagedTensor;

/// A particle as a part of the surface of its fluid: meniscus::Ellipsoid.
typedef struct MeniscusEllipsoid {
  MeniscusVec3 centre;    ///< m
  MeniscusVec3 radii;     ///< m, along x, y and z of its frame
  MeniscusQuat rotation;  ///< from its frame to the world's
} MeniscusEllipsoid;

/// A particle of spray (0), foam (1) or a bubble (2): meniscus::DiffuseParticle.
typedef struct MeniscusDiffuseParticle {
  MeniscusVec3 position;  ///< m
  MeniscusVec3 velocity;  ///< m/s
  float life;             ///< s, remaining
  uint32_t kind;          ///< 0 is spray, 1 foam, 2 a bubble
} MeniscusDiffuseParticle;

/// The number of particles.
MENISCUS_C_API MeniscusStatus meniscus_particle_count(const MeniscusWorld* world, size_t* count);
/// The ids of particles, in ascending order.
MENISCUS_C_API MeniscusStatus meniscus_ids(const MeniscusWorld* world, const uint64_t** ids, size_t* count);
/// m.
MENISCUS_C_API MeniscusStatus meniscus_positions(const MeniscusWorld* world, const MeniscusVec3** positions,
                                                 size_t* count);
/// m/s.
MENISCUS_C_API MeniscusStatus meniscus_velocities(const MeniscusWorld* world, const MeniscusVec3** velocities,
                                                  size_t* count);
/// MeniscusId::index of the fluid or granular material.
MENISCUS_C_API MeniscusStatus meniscus_fluids(const MeniscusWorld* world, const uint32_t** fluids,
                                              size_t* count);
/// C = ρ/ρ₀ − 1, at the present positions.
MENISCUS_C_API MeniscusStatus meniscus_density_errors(const MeniscusWorld* world, const float** errors,
                                                      size_t* count);
/// Pa, of the last substep.
MENISCUS_C_API MeniscusStatus meniscus_pressures(const MeniscusWorld* world, const float** pressures,
                                                 size_t* count);
/// Ellipsoids whose outsides form the surface of the fluid: World::ellipsoids.
MENISCUS_C_API MeniscusStatus meniscus_ellipsoids(const MeniscusWorld* world,
                                                  const MeniscusEllipsoid** ellipsoids, size_t* count);
/// Writes ellipsoids, fluids and velocities, m/s, to arrays in the memory of the world's device:
/// World::write_particles. Velocities may be null.
MENISCUS_C_API MeniscusStatus meniscus_write_particles(const MeniscusWorld* world,
                                                       MeniscusEllipsoid* ellipsoids, uint32_t* fluids,
                                                       MeniscusVec3* velocities);
/// An array of World::device_arrays.
typedef enum MeniscusDeviceArray MENISCUS_ANY_INT {
  MENISCUS_DEVICE_IDS = 0,         ///< uint64
  MENISCUS_DEVICE_POSITIONS = 1,   ///< float32, count × 3, m
  MENISCUS_DEVICE_VELOCITIES = 2,  ///< float32, count × 3, m/s
  MENISCUS_DEVICE_PHASES = 3       ///< uint32: the indices of fluids
} MeniscusDeviceArray;

/// Particles in the memory of the world's device, in the order of their ids, as a tensor of DLPack 0.x. Call
/// its deleter when done. `stream` is the cudaStream_t that fills it, null on the CPU; it may be null.
MENISCUS_C_API MeniscusStatus meniscus_dlpack(const MeniscusWorld* world, MeniscusDeviceArray array,
                                              struct DLManagedTensor** tensor, void** stream);
/// Spray, foam and bubbles, in the order of their creation.
MENISCUS_C_API MeniscusStatus meniscus_diffuse(const MeniscusWorld* world,
                                               const MeniscusDiffuseParticle** particles, size_t* count);

/// The surface of a fluid, closed. Arrays are valid until the next call of meniscus_surface_mesh().
typedef struct MeniscusSurfaceMesh {
  uint32_t size;                   ///< of this struct
  const MeniscusVec3* vertices;    ///< m
  const MeniscusVec3* normals;     ///< unit, one a vertex, out of the fluid
  size_t vertex_count;             ///< number of vertices
  const uint32_t* triangles;       ///< three numbers of vertices each, counter-clockwise as seen from outside
  size_t triangle_count;           ///< number of triangles
  const MeniscusVec3* velocities;  ///< m/s, one a vertex
} MeniscusSurfaceMesh;

/// Makes the surface around the ellipsoids. A null definition means the defaults.
MENISCUS_C_API MeniscusStatus meniscus_surface_mesh(MeniscusWorld* world, const MeniscusDef* def,
                                                    MeniscusSurfaceMesh* mesh);

/// OpenGL buffers that worlds on CUDA write to: meniscus::GlParticles.
typedef struct MeniscusGlParticles MeniscusGlParticles;

/// Takes the names of buffers: 40 bytes a particle for ellipsoids, 4 for fluids, and 12 for velocities, or 0
/// for no such buffer. The context of the buffers must be current.
MENISCUS_C_API MeniscusStatus meniscus_gl_particles_create(uint32_t ellipsoids, uint32_t fluids,
                                                           uint32_t velocities,
                                                           MeniscusGlParticles** buffers);
/// Releases the buffers. Null is allowed.
MENISCUS_C_API void meniscus_gl_particles_destroy(MeniscusGlParticles* buffers);
/// Writes what the buffers are for.
MENISCUS_C_API MeniscusStatus meniscus_write_gl_particles(const MeniscusWorld* world,
                                                          MeniscusGlParticles* buffers);

#ifdef __cplusplus
}
#endif
