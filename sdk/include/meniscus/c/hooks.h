// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: calls of the user within a substep. meniscus/hooks.h says what they may do.
#pragma once

#include <meniscus/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// A point of a substep: meniscus::Hook.
typedef enum MeniscusHook MENISCUS_ANY_INT {
  MENISCUS_PREDICTED = 0,
  MENISCUS_CONTACTS_FOUND = 1,
  MENISCUS_ITERATED = 2,
  MENISCUS_SOLVED = 3,
  MENISCUS_VELOCITIES_KNOWN = 4
} MeniscusHook;

/// The particles of a substep: meniscus::SubstepView. All is valid within the call alone.
typedef struct MeniscusSubstep {
  uint32_t size;           ///< of this struct
  uint32_t hook;           ///< a MeniscusHook
  int32_t on_cuda;         ///< 0 or 1
  int32_t device;          ///< CUDA ordinal
  void* stream;            ///< cudaStream_t; null on the CPU
  float dt;                ///< s, of the substep
  int32_t iteration;       ///< of MENISCUS_ITERATED, from 0
  int32_t is_last;         ///< 0 or 1: whether it is the last substep of its step
  uint32_t particles;      ///< of fluids and grains
  uint32_t vertices;       ///< of cloth and ropes, behind the particles
  float* positions;        ///< four floats each: m, and the inverse mass in 1/kg
  const float* previous;   ///< m, at the start of the substep; null at MENISCUS_VELOCITIES_KNOWN
  float* corrections;      ///< m, so far; null at MENISCUS_VELOCITIES_KNOWN
  float* velocities;       ///< m/s
  const uint32_t* phases;  ///< low 16 bits: the index of the fluid or the number of the piece
  const uint32_t* slots;   ///< the index in meniscus_ids(), or 2³¹ + the number of a vertex
} MeniscusSubstep;

/// A call within a substep. It returns 0, or another number to end the step with MENISCUS_CANCELLED. The
/// state is then that before the step.
typedef int (*MeniscusSubstepCall)(const MeniscusSubstep* substep, void* user);
/// Adds a call, after those that were added before: World::add_hook.
MENISCUS_C_API MeniscusStatus meniscus_add_hook(MeniscusWorld* world, MeniscusHook hook,
                                                MeniscusSubstepCall call, void* user, uint64_t* id);
/// Removes a call. MENISCUS_NOT_FOUND if it is not there.
MENISCUS_C_API MeniscusStatus meniscus_remove_hook(MeniscusWorld* world, uint64_t id);

#ifdef __cplusplus
}
#endif
