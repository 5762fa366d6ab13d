// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: recordings of all calls that changed a world. meniscus/recording.h describes them.
#pragma once

#include <meniscus/c/state.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Begins to write all calls that change the world to a file: World::start_recording.
MENISCUS_C_API MeniscusStatus meniscus_start_recording(MeniscusWorld* world, const char* path);
/// Ends the recording. MENISCUS_IO if not all could be written.
MENISCUS_C_API MeniscusStatus meniscus_stop_recording(MeniscusWorld* world);

/// A recording that is read: meniscus::Replay.
typedef struct MeniscusReplay MeniscusReplay;

/// A step that a replay has made again.
typedef struct MeniscusReplayStep {
  uint32_t size;           ///< of this struct
  int32_t is_there;        ///< 0 at the end of the recording; the rest is then 0
  int32_t is_complete;     ///< at the end: whether the recording was ended by meniscus_stop_recording()
  int32_t iterations;      ///< per substep
  double time;             ///< s, of the world after the step
  uint64_t hash;           ///< meniscus_state_hash() after it
  uint64_t recorded_hash;  ///< the same in the run that was recorded
} MeniscusReplayStep;

/// Opens a recording. Close it with meniscus_replay_close().
MENISCUS_C_API MeniscusStatus meniscus_replay_open(const char* path, MeniscusReplay** replay);
/// Closes a recording. Null is allowed.
MENISCUS_C_API void meniscus_replay_close(MeniscusReplay* replay);
/// Makes the world at the beginning. `def` may be null. Destroy the world with meniscus_world_destroy().
MENISCUS_C_API MeniscusStatus meniscus_replay_start(MeniscusReplay* replay, const MeniscusLoadDef* def,
                                                    MeniscusWorld** world);
/// Repeats calls on that world, to the end of the next step.
MENISCUS_C_API MeniscusStatus meniscus_replay_next(MeniscusReplay* replay, MeniscusWorld* world,
                                                   MeniscusReplayStep* step);

#ifdef __cplusplus
}
#endif
