// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: snapshots and files of whole worlds, and the objects that a world has.
#pragma once

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
/// Makes a world with the state of a file. `device` is "auto", "cpu" or "cuda"; null means that of the saved
/// world. So does a negative number of threads. Destroy the world with meniscus_world_destroy().
MENISCUS_C_API MeniscusStatus meniscus_load(const char* path, const char* device, int threads,
                                            MeniscusWorld** world);
/// Makes a world with the same state, as if by saving and loading.
MENISCUS_C_API MeniscusStatus meniscus_clone(const MeniscusWorld* world, const char* device, int threads,
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
