// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: cloth, ropes and attachments.
#pragma once

#include <meniscus/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// The state of a piece of cloth: meniscus::ClothState.
typedef struct MeniscusClothState {
  uint32_t size;          ///< of this struct
  int32_t closed;         ///< 0 or 1
  float mass;             ///< kg, with the fluid that it holds
  float fluid_mass;       ///< kg, of that fluid
  float area;             ///< m², at rest
  float mean_stretch;     ///< mean of |l/L − 1| over edges
  float max_stretch;      ///< largest l/L
  float volume;           ///< m³, of a closed piece
  float pressure;         ///< Pa, overpressure of its gas
  MeniscusVec3 centre;    ///< m, of mass
  MeniscusVec3 momentum;  ///< kg·m/s
  float kinetic_energy;   ///< J
} MeniscusClothState;

/// A vertex that tore in two in the last step. `original` keeps its number, and `copy` is the new one.
typedef struct MeniscusTearEvent {
  MeniscusId cloth;   ///< the piece
  uint32_t copy;      ///< the number of the new vertex
  uint32_t original;  ///< the number of the vertex that tore
} MeniscusTearEvent;

/// m, one a vertex.
MENISCUS_C_API MeniscusStatus meniscus_cloth_positions(const MeniscusWorld* world, MeniscusId cloth,
                                                       const MeniscusVec3** positions, size_t* count);
/// m/s, one a vertex.
MENISCUS_C_API MeniscusStatus meniscus_cloth_velocities(const MeniscusWorld* world, MeniscusId cloth,
                                                        const MeniscusVec3** velocities, size_t* count);
/// Unit, one a vertex.
MENISCUS_C_API MeniscusStatus meniscus_cloth_normals(const MeniscusWorld* world, MeniscusId cloth,
                                                     const MeniscusVec3** normals, size_t* count);
/// Numbers of vertices, three a triangle. `count` is that of the numbers.
MENISCUS_C_API MeniscusStatus meniscus_cloth_triangles(const MeniscusWorld* world, MeniscusId cloth,
                                                       const uint32_t** vertices, size_t* count);
/// A place in a texture: meniscus::TexturePoint.
typedef struct MeniscusTexturePoint {
  float u;  ///< to the right
  float v;  ///< up
} MeniscusTexturePoint;
/// Texture coordinates, one a corner of the triangles, or none: World::cloth_texture.
MENISCUS_C_API MeniscusStatus meniscus_cloth_texture(const MeniscusWorld* world, MeniscusId cloth,
                                                     const MeniscusTexturePoint** texture, size_t* count);
/// The largest principal strain, one a triangle.
MENISCUS_C_API MeniscusStatus meniscus_cloth_strains(const MeniscusWorld* world, MeniscusId cloth,
                                                     const float** strains, size_t* count);
/// The fluid that each vertex holds over FabricDef::absorbency.
MENISCUS_C_API MeniscusStatus meniscus_cloth_wetness(const MeniscusWorld* world, MeniscusId cloth,
                                                     const float** wetness, size_t* count);
/// How many vertices of its file were merged into others.
MENISCUS_C_API MeniscusStatus meniscus_cloth_welded_vertices(const MeniscusWorld* world, MeniscusId cloth,
                                                             uint32_t* count);
/// The least part of its bending stiffness that substeps have resolved: World::cloth_bending_fraction.
MENISCUS_C_API MeniscusStatus meniscus_cloth_bending_fraction(const MeniscusWorld* world, MeniscusId cloth,
                                                              float* fraction);
/// Reads the state of a piece of cloth.
MENISCUS_C_API MeniscusStatus meniscus_cloth_state(const MeniscusWorld* world, MeniscusId cloth,
                                                   MeniscusClothState* state);
/// Vertices that tore in the last step.
MENISCUS_C_API MeniscusStatus meniscus_tear_events(MeniscusWorld* world, const MeniscusTearEvent** events,
                                                   size_t* count);
/// m, one a vertex.
MENISCUS_C_API MeniscusStatus meniscus_rope_positions(const MeniscusWorld* world, MeniscusId rope,
                                                      const MeniscusVec3** positions, size_t* count);
/// m/s, one a vertex.
MENISCUS_C_API MeniscusStatus meniscus_rope_velocities(const MeniscusWorld* world, MeniscusId rope,
                                                       const MeniscusVec3** velocities, size_t* count);
/// One a segment of a rod, z along it. Ropes have none.
MENISCUS_C_API MeniscusStatus meniscus_rope_frames(const MeniscusWorld* world, MeniscusId rope,
                                                   const MeniscusQuat** frames, size_t* count);
/// N·s on vertices of a piece of cloth or a rope, by number, at once. No number may repeat.
MENISCUS_C_API MeniscusStatus meniscus_apply_vertex_impulses(MeniscusWorld* world, MeniscusId cloth_or_rope,
                                                             const uint32_t* vertices,
                                                             const MeniscusVec3* impulses, size_t count);
/// N, of the cloth or rope on what holds it, in the last step.
MENISCUS_C_API MeniscusStatus meniscus_attachment_force(const MeniscusWorld* world, MeniscusId attachment,
                                                        MeniscusVec3* force);
/// The numbers of the vertices that are held.
MENISCUS_C_API MeniscusStatus meniscus_attachment_vertices(MeniscusWorld* world, MeniscusId attachment,
                                                           const uint32_t** vertices, size_t* count);

#ifdef __cplusplus
}
#endif
