// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: status codes, plain values, ids.
#pragma once

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define MENISCUS_C_API __attribute__((visibility("default")))
#else
#define MENISCUS_C_API
#endif

/// C may pass any int as an enum. In C++ its type must say so.
#ifdef __cplusplus
#define MENISCUS_ANY_INT : int
#else
#define MENISCUS_ANY_INT
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// How a call ended. The codes are those of meniscus::ErrorCode.
typedef enum MeniscusStatus MENISCUS_ANY_INT {
  MENISCUS_OK = 0,
  MENISCUS_INVALID_ARGUMENT = 1,  ///< a value that the call does not allow, or a null pointer
  MENISCUS_NOT_FOUND = 2,         ///< an id, a path or a name that does not exist
  MENISCUS_IO = 3,                ///< a file that cannot be read or written
  MENISCUS_PARSE = 4,             ///< a scene with a wrong, missing or unknown key
  MENISCUS_MESH = 5,              ///< an unusable mesh
  MENISCUS_CAPACITY = 6,          ///< a fixed limit was reached; the message names it and the remedy
  MENISCUS_NON_FINITE = 7,        ///< the step met NaN, infinity or too high a speed
  MENISCUS_DEVICE = 8,            ///< CUDA or the driver failed, or the requested device does not exist
  MENISCUS_OUT_OF_MEMORY = 9,     ///< there is not enough memory on the host or on the device
  MENISCUS_CANCELLED = 10,        ///< the call was cancelled by meniscus_cancel()
  MENISCUS_LOST = 11,             ///< an earlier call failed while it changed the world: nothing is usable
  MENISCUS_INTERNAL = 12          ///< an unexpected exception; the message is its text
} MeniscusStatus;

/// Three numbers.
typedef struct MeniscusVec3 {
  float x, y, z;  ///< along the axes
} MeniscusVec3;

/// A rotation; (0, 0, 0, 1) is none.
typedef struct MeniscusQuat {
  float x, y, z, w;  ///< w is the scalar part
} MeniscusQuat;

/// A placement: a point q of the local frame sits at position + rotation · q.
typedef struct MeniscusPose {
  MeniscusVec3 position;  ///< m
  MeniscusQuat rotation;  ///< of the local frame
} MeniscusPose;

/// Two objects collide if each one's group is in the mask of the other.
typedef struct MeniscusFilter {
  uint32_t groups;  ///< bits: the groups of the object
  uint32_t mask;    ///< bits: the groups that it collides with
} MeniscusFilter;

/// The kinds of objects that ids name.
typedef enum MeniscusKind MENISCUS_ANY_INT {
  MENISCUS_NONE = 0,
  MENISCUS_FLUID = 1,  ///< a fluid or a granular material
  MENISCUS_SHAPE = 2,
  MENISCUS_BODY = 3,
  MENISCUS_JOINT = 4,
  MENISCUS_CLOTH = 5,
  MENISCUS_ROPE = 6,
  MENISCUS_ATTACHMENT = 7,
  MENISCUS_EMITTER = 8,
  MENISCUS_SINK = 9,
  MENISCUS_PROBE = 10,
  MENISCUS_FORCE_FIELD = 11
} MeniscusKind;

/// Names an object in one world. An id of zeros names nothing. A stale or foreign id is an error.
typedef struct MeniscusId {
  uint32_t kind;        ///< a MeniscusKind
  uint32_t index;       ///< its place among the objects of its kind
  uint32_t generation;  ///< tells it from those that had its place before
} MeniscusId;

/// Of the last call that failed on this thread; empty before. The text is valid until the next failure on
/// this thread. Messages longer than 4 kB are cut.
MENISCUS_C_API const char* meniscus_last_error(void);

/// The word for a status, as in "not_found". It is "unknown" for other values.
MENISCUS_C_API const char* meniscus_status_name(MeniscusStatus status);

/// "MAJOR.MINOR.PATCH" of the library that runs. version.h has the numbers that a program was compiled with.
MENISCUS_C_API const char* meniscus_version(void);

#ifdef __cplusplus
}
#endif
