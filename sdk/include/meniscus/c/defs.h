// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: definitions. A definition has the members of a C++ struct, with their defaults. Members are set by
// path, as in "pose.position", "openings[0].face" or "density.iterations".
//
// A member that is a choice, such as a geometry, takes the word for one of its alternatives as text. It then
// has the members of this alternative: set "geometry" to "sphere", and then "geometry.radius". A setter puts
// a value into an optional member that has none. The words are those of scene files.
#pragma once

#include <meniscus/c/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/// The C++ struct of a definition.
typedef enum MeniscusDefKind MENISCUS_ANY_INT {
  MENISCUS_WORLD_DEF = 0,
  MENISCUS_FLUID_DEF = 1,
  MENISCUS_GRANULAR_DEF = 2,
  MENISCUS_FLUID_VOLUME_DEF = 3,
  MENISCUS_SHAPE_DEF = 4,
  MENISCUS_BODY_DEF = 5,
  MENISCUS_JOINT_DEF = 6,
  MENISCUS_CLOTH_DEF = 7,
  MENISCUS_ROPE_DEF = 8,
  MENISCUS_ATTACHMENT_DEF = 9,
  MENISCUS_WIND_DEF = 10,
  MENISCUS_EMITTER_DEF = 11,
  MENISCUS_SINK_DEF = 12,
  MENISCUS_PROBE_DEF = 13,
  MENISCUS_SURFACE_MESH_DEF = 14,
  MENISCUS_FORCE_FIELD_DEF = 15
} MeniscusDefKind;

/// A definition. Calls that take it copy it.
typedef struct MeniscusDef MeniscusDef;

/// Makes a definition with the defaults. Destroy it with meniscus_def_destroy().
MENISCUS_C_API MeniscusStatus meniscus_def_create(MeniscusDefKind kind, MeniscusDef** def);
/// Copies a definition.
MENISCUS_C_API MeniscusStatus meniscus_def_copy(const MeniscusDef* def, MeniscusDef** copy);
/// Destroys a definition. Null is allowed.
MENISCUS_C_API void meniscus_def_destroy(MeniscusDef* def);

// Setters. A path that does not exist is MENISCUS_NOT_FOUND, and the message lists the members. A member of
// another type is MENISCUS_INVALID_ARGUMENT. Ranges are checked by the call that takes the definition.

/// Sets a number. Whole numbers must be whole and have 32 bits.
MENISCUS_C_API MeniscusStatus meniscus_def_set_number(MeniscusDef* def, const char* path, double value);
/// Sets a flag. Each value but 0 means true.
MENISCUS_C_API MeniscusStatus meniscus_def_set_flag(MeniscusDef* def, const char* path, int value);
/// Sets a text, an enumerator by its word, or the alternative of a choice by its word.
MENISCUS_C_API MeniscusStatus meniscus_def_set_text(MeniscusDef* def, const char* path, const char* value);
/// Sets a vector.
MENISCUS_C_API MeniscusStatus meniscus_def_set_vector(MeniscusDef* def, const char* path, MeniscusVec3 value);
/// Sets a rotation.
MENISCUS_C_API MeniscusStatus meniscus_def_set_rotation(MeniscusDef* def, const char* path,
                                                        MeniscusQuat value);
/// Sets the id of another object. The kind of the id must fit the member.
MENISCUS_C_API MeniscusStatus meniscus_def_set_id(MeniscusDef* def, const char* path, MeniscusId value);
/// Sets a list of numbers. The values may be null if the count is 0.
MENISCUS_C_API MeniscusStatus meniscus_def_set_numbers(MeniscusDef* def, const char* path,
                                                       const float* values, size_t count);
/// Sets a list of vectors. The values may be null if the count is 0.
MENISCUS_C_API MeniscusStatus meniscus_def_set_vectors(MeniscusDef* def, const char* path,
                                                       const MeniscusVec3* values, size_t count);
/// Sets a list of whole numbers, such as vertices. The values may be null if the count is 0.
MENISCUS_C_API MeniscusStatus meniscus_def_set_indices(MeniscusDef* def, const char* path,
                                                       const uint32_t* values, size_t count);
/// Sets the length of a list. New items have the defaults. An optional member is a list of at most one item.
MENISCUS_C_API MeniscusStatus meniscus_def_resize(MeniscusDef* def, const char* path, size_t count);

// Getters. An optional member without a value is MENISCUS_NOT_FOUND.

/// Reads a number.
MENISCUS_C_API MeniscusStatus meniscus_def_get_number(const MeniscusDef* def, const char* path,
                                                      double* value);
/// Reads a flag as 0 or 1.
MENISCUS_C_API MeniscusStatus meniscus_def_get_flag(const MeniscusDef* def, const char* path, int* value);
/// Reads a text, or the word of an enumerator or choice. It is valid until the definition changes.
MENISCUS_C_API MeniscusStatus meniscus_def_get_text(const MeniscusDef* def, const char* path,
                                                    const char** value);
/// Reads a vector.
MENISCUS_C_API MeniscusStatus meniscus_def_get_vector(const MeniscusDef* def, const char* path,
                                                      MeniscusVec3* value);
/// Reads a rotation.
MENISCUS_C_API MeniscusStatus meniscus_def_get_rotation(const MeniscusDef* def, const char* path,
                                                        MeniscusQuat* value);
/// Reads an id.
MENISCUS_C_API MeniscusStatus meniscus_def_get_id(const MeniscusDef* def, const char* path,
                                                  MeniscusId* value);
/// Reads a list of numbers. It is valid until the definition changes, as the next two are.
MENISCUS_C_API MeniscusStatus meniscus_def_get_numbers(const MeniscusDef* def, const char* path,
                                                       const float** values, size_t* count);
/// Reads a list of vectors.
MENISCUS_C_API MeniscusStatus meniscus_def_get_vectors(const MeniscusDef* def, const char* path,
                                                       const MeniscusVec3** values, size_t* count);
/// Reads a list of whole numbers.
MENISCUS_C_API MeniscusStatus meniscus_def_get_indices(const MeniscusDef* def, const char* path,
                                                       const uint32_t** values, size_t* count);
/// Reads the length of a list, or 0 or 1 for an optional member.
MENISCUS_C_API MeniscusStatus meniscus_def_get_count(const MeniscusDef* def, const char* path, size_t* count);

/// The type of a member, which names its setter.
typedef enum MeniscusMemberType MENISCUS_ANY_INT {
  MENISCUS_NUMBER = 0,
  MENISCUS_WHOLE_NUMBER = 1,  ///< set as a number
  MENISCUS_FLAG = 2,
  MENISCUS_TEXT = 3,
  MENISCUS_WORD = 4,    ///< an enumerator, set as a text
  MENISCUS_CHOICE = 5,  ///< set as a text
  MENISCUS_VECTOR = 6,
  MENISCUS_ROTATION = 7,
  MENISCUS_ID = 8,
  MENISCUS_NUMBERS = 9,
  MENISCUS_VECTORS = 10,
  MENISCUS_INDICES = 11,
  MENISCUS_LIST = 12  ///< of items with members; set by meniscus_def_resize()
} MeniscusMemberType;

/// A member as meniscus_def_members() lists it. The texts are valid during the callback.
typedef struct MeniscusMember {
  uint32_t size;        ///< of this struct
  uint32_t type;        ///< a MeniscusMemberType
  const char* path;     ///< members of list items have the index 0
  const char* needs;    ///< words that must be set before, as in "geometry=box;"; empty if none
  const char* unit;     ///< may be empty
  const char* meaning;  ///< what it is, in words
  const char* words;    ///< for a word or choice: the words, separated by commas; else empty
  double low, high;     ///< bounds of numbers, infinite if there are none, in the unit of the member
  int32_t is_optional;  ///< 0 or 1: whether it may be left out
} MeniscusMember;

/// Calls `use` for each member of a kind of definition. `user` is passed on and may be null.
MENISCUS_C_API MeniscusStatus meniscus_def_members(MeniscusDefKind kind,
                                                   void (*use)(const MeniscusMember* member, void* user),
                                                   void* user);

#ifdef __cplusplus
}
#endif
