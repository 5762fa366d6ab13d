// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: snapshots and files of whole worlds, and the objects that a world has.
#pragma once

#include <meniscus/c/host.h>
#include <meniscus/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// The state of a world at one moment: meniscus::Snapshot.
typedef struct MeniscusSnapshot MeniscusSnapshot;

/// Takes a snapshot, whose arrays stay on the device. Destroy it with meniscus_snapshot_destroy().
MENISCUS_C_API MeniscusStatus meniscus_snapshot(const MeniscusWorld* world, MeniscusSnapshot** snapshot);
/// Frees a snapshot. Null is allowed.
MENISCUS_C_API void meniscus_snapshot_destroy(MeniscusSnapshot* snapshot);
/// Goes back to a snapshot of this world: World::restore.
MENISCUS_C_API MeniscusStatus meniscus_restore(MeniscusWorld* world, const MeniscusSnapshot* snapshot);

/// Writes the whole state to a file, which appears complete or not at all: World::save.
MENISCUS_C_API MeniscusStatus meniscus_save(const MeniscusWorld* world, const char* path);
/// How a world is made from a state: meniscus::LoadDef. Begin with meniscus_load_def_init(). `user` is passed
/// to all callbacks.
typedef struct MeniscusLoadDef {
  uint32_t size;                     ///< of this struct
  int32_t threads;                   ///< of the CPU device; negative: as the saved world
  int32_t cuda_device;               ///< ordinal of the GPU; negative: as the saved world
  const char* device;                ///< "auto", "cpu" or "cuda"; null: as the saved world
  void* cuda_stream;                 ///< a cudaStream_t, or null
  MeniscusReadFile read_file;        ///< WorldDef::read_file, or null
  MeniscusLog log;                   ///< WorldDef::log, or null
  MeniscusParallelFor parallel_for;  ///< WorldDef::parallel_for, or null
  void* user;                        ///< what the callbacks get
} MeniscusLoadDef;

/// Sets size and defaults.
MENISCUS_C_API void meniscus_load_def_init(MeniscusLoadDef* def);
/// Makes a world with the state of a file. `def` may be null. Destroy the world with
/// meniscus_world_destroy().
MENISCUS_C_API MeniscusStatus meniscus_load(const char* path, const MeniscusLoadDef* def,
                                            MeniscusWorld** world);
/// Makes a world with the same state, as if by saving and loading.
MENISCUS_C_API MeniscusStatus meniscus_clone(const MeniscusWorld* world, const MeniscusLoadDef* def,
                                             MeniscusWorld** copy);

/// Lists what exists of a kind, in the order of the indices of ids.
MENISCUS_C_API MeniscusStatus meniscus_objects(MeniscusWorld* world, MeniscusKind kind,
                                               const MeniscusId** ids, size_t* count);
/// Finds the first object of a kind with this name. MENISCUS_NOT_FOUND if there is none.
MENISCUS_C_API MeniscusStatus meniscus_find(const MeniscusWorld* world, MeniscusKind kind, const char* name,
                                            MeniscusId* id);

#ifdef __cplusplus
}
#endif
