// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Recordings of C.
#include <meniscus/c/recording.h>
#include <meniscus/recording.h>

#include <memory>

#include "sdk/c/handles.h"
#include "sdk/c/host.h"

struct MeniscusReplay {
  meniscus::Replay replay;
};

using namespace meniscus::c;
using namespace meniscus;

MeniscusStatus meniscus_start_recording(MeniscusWorld* world, const char* path) {
  return guarded([&] { world_of(world).start_recording(&required(path, "path")); });
}

MeniscusStatus meniscus_stop_recording(MeniscusWorld* world) {
  return guarded([&] { world_of(world).stop_recording(); });
}

MeniscusStatus meniscus_replay_open(const char* path, MeniscusReplay** replay) {
  return guarded([&] {
    MeniscusReplay*& out = required(replay, "replay");
    out = std::make_unique<MeniscusReplay>(MeniscusReplay{Replay(&required(path, "path"))}).release();
  });
}

void meniscus_replay_close(MeniscusReplay* replay) {
  delete replay;
}

MeniscusStatus meniscus_replay_start(MeniscusReplay* replay, const MeniscusLoadDef* def,
                                     MeniscusWorld** world) {
  return guarded([&] {
    MeniscusWorld*& out = required(world, "world");
    Replay& read = required(replay, "replay").replay;
    out = std::make_unique<MeniscusWorld>(MeniscusWorld{read.start(load_def_of(def))}).release();
  });
}

MeniscusStatus meniscus_replay_next(MeniscusReplay* replay, MeniscusWorld* world, MeniscusReplayStep* step) {
  return guarded([&] {
    check_size(required(step, "step"));
    Replay& read = required(replay, "replay").replay;
    const std::optional<ReplayStep> made = read.next(world_of(world));
    MeniscusReplayStep result{};
    result.is_complete = read.is_complete() ? 1 : 0;
    if (made) {
      result.is_there = 1;
      result.iterations = made->report.iterations;
      result.time = made->time;
      result.hash = made->hash;
      result.recorded_hash = made->recorded_hash;
    }
    write_result(step, result);
  });
}
