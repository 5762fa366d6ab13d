// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: scene files. meniscus/scene.h describes them.
#pragma once

#include <meniscus/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// A scene: meniscus::Scene.
typedef struct MeniscusScene MeniscusScene;

/// Reads a scene file. Each override is "path=value". `overrides` may be null if the count is 0. Destroy the
/// scene with meniscus_scene_destroy().
MENISCUS_C_API MeniscusStatus meniscus_scene_read(const char* path, const char* const* overrides,
                                                  size_t override_count, MeniscusScene** scene);
/// Reads a scene from the text of a file. Paths of mesh files start from `folder`, which may be null.
MENISCUS_C_API MeniscusStatus meniscus_scene_read_text(const char* text, const char* folder,
                                                       MeniscusScene** scene);
/// Destroys a scene. Null is allowed.
MENISCUS_C_API void meniscus_scene_destroy(MeniscusScene* scene);

/// The parts of the last error of a scene on this thread: see meniscus::SceneError. The texts are empty if
/// the last failure was another. They are valid until the next failure on this thread.
MENISCUS_C_API void meniscus_scene_error(const char** file, const char** path, const char** fix);

/// What a program needs to run a scene.
typedef struct MeniscusSceneInfo {
  uint32_t size;            ///< of this struct
  int32_t frames;           ///< length of a run, unless the caller says otherwise
  float frame_time;         ///< s: one meniscus_step()
  const char* name;         ///< valid as long as the scene
  const char* description;  ///< what there is to see
} MeniscusSceneInfo;

/// Reads name, length and frame time of a scene.
MENISCUS_C_API MeniscusStatus meniscus_scene_info(const MeniscusScene* scene, MeniscusSceneInfo* info);
/// Checks the names and values of a scene, without making a world.
MENISCUS_C_API MeniscusStatus meniscus_scene_check(const MeniscusScene* scene);
/// Makes a world of a scene. The world does not need the scene any more.
MENISCUS_C_API MeniscusStatus meniscus_scene_build(const MeniscusScene* scene, MeniscusWorld** world);
/// The object with a number among those of a kind, in the order of the scene that the world was built from.
/// Granular materials follow the fluids. `id` and `name` may be null. MENISCUS_NOT_FOUND beyond the last one.
MENISCUS_C_API MeniscusStatus meniscus_scene_item(const MeniscusWorld* world, MeniscusKind kind,
                                                  size_t number, MeniscusId* id, const char** name);
/// The JSON Schema of scene files. It is valid until the program ends.
MENISCUS_C_API MeniscusStatus meniscus_scene_schema(const char** schema);

#ifdef __cplusplus
}
#endif
