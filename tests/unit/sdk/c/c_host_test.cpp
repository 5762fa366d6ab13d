// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Callbacks of C: files, logs, loops and hooks of a program, and its recordings.
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

#include "tests/unit/sdk/c/c_scenes.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

struct Destroy {
  void operator()(MeniscusWorld* world) const { meniscus_world_destroy(world); }
  void operator()(MeniscusDef* def) const { meniscus_def_destroy(def); }
  void operator()(MeniscusReplay* replay) const { meniscus_replay_close(replay); }
};
template <class Handle>
using Owned = std::unique_ptr<Handle, Destroy>;

class CHost : public OnDevice {
 protected:
  const char* device() const { return GetParam() == pbd::DeviceKind::cuda ? "cuda" : "cpu"; }
  Owned<MeniscusDef> world_def() const {
    MeniscusDef* def = nullptr;
    EXPECT_EQ(meniscus_def_create(MENISCUS_WORLD_DEF, &def), MENISCUS_OK);
    EXPECT_EQ(meniscus_def_set_text(def, "device", device()), MENISCUS_OK);
    return Owned<MeniscusDef>(def);
  }
  static Owned<MeniscusWorld> made(const MeniscusDef* def) {
    MeniscusWorld* world = nullptr;
    EXPECT_EQ(meniscus_world_create(def, &world), MENISCUS_OK) << meniscus_last_error();
    return Owned<MeniscusWorld>(world);
  }
  Owned<MeniscusWorld> tank() const {
    MeniscusWorld* world = nullptr;
    MeniscusId body{};
    EXPECT_EQ(c_tank_with_body(device(), &world, &body), MENISCUS_OK) << meniscus_last_error();
    return Owned<MeniscusWorld>(world);
  }
  static uint64_t hash_of(MeniscusWorld* world) {
    uint64_t hash = 0;
    EXPECT_EQ(meniscus_state_hash(world, &hash), MENISCUS_OK);
    return hash;
  }
};

constexpr const char* tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

int read_archive(const char* name, MeniscusFileBytes* file, void* user) {
  ++*static_cast<int*>(user);
  if (std::string(name) != "pack/solid.obj") return 0;
  return meniscus_file_bytes(file, tetrahedron, std::strlen(tetrahedron)) == MENISCUS_OK;
}

TEST_P(CHost, FilesComeFromTheProgram) {
  const Owned<MeniscusDef> def = world_def();
  int reads = 0;
  ASSERT_EQ(meniscus_def_set_read_file(def.get(), read_archive, &reads), MENISCUS_OK);
  const Owned<MeniscusWorld> world = made(def.get());
  MeniscusDef* shape = nullptr;
  ASSERT_EQ(meniscus_def_create(MENISCUS_SHAPE_DEF, &shape), MENISCUS_OK);
  const Owned<MeniscusDef> owned(shape);
  ASSERT_EQ(meniscus_def_set_text(shape, "geometry", "mesh"), MENISCUS_OK);
  ASSERT_EQ(meniscus_def_set_text(shape, "geometry.file", "pack/solid.obj"), MENISCUS_OK);
  MeniscusId id{};
  EXPECT_EQ(meniscus_create(world.get(), shape, &id), MENISCUS_OK) << meniscus_last_error();
  EXPECT_GT(reads, 0);
  ASSERT_EQ(meniscus_def_set_text(shape, "geometry.file", "pack/none.obj"), MENISCUS_OK);
  EXPECT_EQ(meniscus_create(world.get(), shape, &id), MENISCUS_IO);
  EXPECT_EQ(meniscus_def_set_read_file(shape, read_archive, &reads), MENISCUS_INVALID_ARGUMENT);
}

TEST_P(CHost, MessagesGoToTheLog) {
  const Owned<MeniscusDef> def = world_def();
  std::map<MeniscusLogLevel, int> counts;
  const auto count = [](MeniscusLogLevel level, const char* text, void* user) {
    EXPECT_GT(std::strlen(text), 10u);
    ++(*static_cast<std::map<MeniscusLogLevel, int>*>(user))[level];
  };
  ASSERT_EQ(meniscus_def_set_log(def.get(), count, &counts), MENISCUS_OK);
  made(def.get());
  EXPECT_EQ(counts[MENISCUS_NOTE], 1);
  EXPECT_EQ(counts[MENISCUS_WARNING], 0);
}

void run_loop(uint32_t count, uint32_t grain, const MeniscusLoopBody* body, void* user) {
  ++*static_cast<std::atomic<int>*>(user);
  for (uint32_t end = count; end > 0;) {
    const uint32_t begin = end > grain ? end - grain : 0;
    meniscus_loop_run(body, begin, end);
    end = begin;
  }
}

TEST_P(CHost, LoopsRunInThoseOfTheProgram) {
  if (GetParam() == pbd::DeviceKind::cuda) GTEST_SKIP() << "a GPU uses none";
  const Owned<MeniscusWorld> world = tank();
  std::atomic<int> loops = 0;
  MeniscusLoadDef load;
  meniscus_load_def_init(&load);
  load.parallel_for = run_loop;
  load.user = &loops;
  MeniscusWorld* cloned = nullptr;
  ASSERT_EQ(meniscus_clone(world.get(), &load, &cloned), MENISCUS_OK) << meniscus_last_error();
  const Owned<MeniscusWorld> clone(cloned);
  ASSERT_EQ(meniscus_step(world.get(), 0.01f, nullptr), MENISCUS_OK);
  ASSERT_EQ(meniscus_step(cloned, 0.01f, nullptr), MENISCUS_OK);
  EXPECT_GT(loops, 10);
  EXPECT_EQ(hash_of(cloned), hash_of(world.get()));
}

int count_calls(const MeniscusSubstep* substep, void* user) {
  EXPECT_EQ(substep->size, sizeof *substep);
  EXPECT_EQ(substep->hook, uint32_t{MENISCUS_SOLVED});
  EXPECT_GT(substep->particles, 0u);
  return ++*static_cast<int*>(user) > 100 ? 7 : 0;
}

TEST_P(CHost, HooksAreCalledUntilTheyAreRemoved) {
  const Owned<MeniscusWorld> world = tank();
  int calls = 0;
  uint64_t id = 0;
  ASSERT_EQ(meniscus_add_hook(world.get(), MENISCUS_SOLVED, count_calls, &calls, &id), MENISCUS_OK);
  ASSERT_EQ(meniscus_step(world.get(), 0.01f, nullptr), MENISCUS_OK);
  EXPECT_GT(calls, 0);
  const uint64_t before = hash_of(world.get());
  calls = 1000;
  EXPECT_EQ(meniscus_step(world.get(), 0.01f, nullptr), MENISCUS_CANCELLED);
  EXPECT_NE(std::string(meniscus_last_error()).find("7"), std::string::npos);
  EXPECT_EQ(hash_of(world.get()), before);
  ASSERT_EQ(meniscus_remove_hook(world.get(), id), MENISCUS_OK);
  EXPECT_EQ(meniscus_remove_hook(world.get(), id), MENISCUS_NOT_FOUND);
  EXPECT_EQ(meniscus_step(world.get(), 0.01f, nullptr), MENISCUS_OK);
}

TEST_P(CHost, ARecordingIsRepeated) {
  const std::string path =
      (std::filesystem::path(testing::TempDir()) / ("c_" + std::to_string(getpid()) + ".menisrec")).string();
  const Owned<MeniscusWorld> world = tank();
  ASSERT_EQ(meniscus_start_recording(world.get(), path.c_str()), MENISCUS_OK) << meniscus_last_error();
  ASSERT_EQ(meniscus_step_iterated(world.get(), 0.01f, 3, nullptr), MENISCUS_OK);
  ASSERT_EQ(meniscus_step(world.get(), 0.01f, nullptr), MENISCUS_OK);
  ASSERT_EQ(meniscus_stop_recording(world.get()), MENISCUS_OK);
  MeniscusReplay* opened = nullptr;
  ASSERT_EQ(meniscus_replay_open(path.c_str(), &opened), MENISCUS_OK) << meniscus_last_error();
  const Owned<MeniscusReplay> replay(opened);
  MeniscusWorld* started = nullptr;
  ASSERT_EQ(meniscus_replay_start(opened, nullptr, &started), MENISCUS_OK) << meniscus_last_error();
  const Owned<MeniscusWorld> again(started);
  MeniscusReplayStep step{};
  step.size = sizeof step;
  for (int k = 0; k < 2; ++k) {
    ASSERT_EQ(meniscus_replay_next(opened, started, &step), MENISCUS_OK) << meniscus_last_error();
    EXPECT_EQ(step.is_there, 1);
    EXPECT_EQ(step.hash, step.recorded_hash);
    if (k == 0) {
      EXPECT_EQ(step.iterations, 3);
    }
  }
  ASSERT_EQ(meniscus_replay_next(opened, started, &step), MENISCUS_OK);
  EXPECT_EQ(step.is_there, 0);
  EXPECT_EQ(step.is_complete, 1);
  EXPECT_EQ(hash_of(started), hash_of(world.get()));
  std::filesystem::remove(path);
}

TEST_P(CHost, QueriesAndEventsAreThoseOfCpp) {
  const Owned<MeniscusWorld> world = tank();
  MeniscusNearestPoint place{};
  place.size = sizeof place;
  ASSERT_EQ(meniscus_nearest(world.get(), {0, 0.01f, 0}, 1, MENISCUS_PARTICLES, &place), MENISCUS_OK);
  EXPECT_EQ(place.is_there, 1);
  EXPECT_EQ(place.thing.kind, uint32_t{MENISCUS_NONE});
  EXPECT_EQ(meniscus_nearest(world.get(), {0, 0, 0}, 1, 99, &place), MENISCUS_INVALID_ARGUMENT);
  MeniscusFluidSample sample{};
  const MeniscusVec3 at = place.point;
  ASSERT_EQ(meniscus_sample_fluid(world.get(), &at, 1, nullptr, &sample), MENISCUS_OK);
  EXPECT_GT(sample.density, 100);
  EXPECT_GT(sample.particles, 1u);
  const MeniscusSleepEvent* sleeps = nullptr;
  const MeniscusFlowEvent* flows = nullptr;
  size_t count = 1;
  ASSERT_EQ(meniscus_sleep_events(world.get(), &sleeps, &count), MENISCUS_OK);
  EXPECT_EQ(count, 0u);
  MeniscusWorld* made = nullptr;
  MeniscusId emitter{}, sink{};
  ASSERT_EQ(c_emitter_and_sink(device(), &made, &emitter, &sink), MENISCUS_OK) << meniscus_last_error();
  const Owned<MeniscusWorld> flow(made);
  uint64_t events = 0, total = 0;
  uint32_t last = 0;
  for (int k = 0; k < 10; ++k) {
    ASSERT_EQ(meniscus_step(made, 0.02f, nullptr), MENISCUS_OK);
    ASSERT_EQ(meniscus_flow_events(made, &flows, &count), MENISCUS_OK);
    for (size_t i = 0; i < count; ++i) events += flows[i].by.kind == MENISCUS_EMITTER;
  }
  ASSERT_EQ(meniscus_flow_count(made, emitter, &last, &total), MENISCUS_OK);
  EXPECT_EQ(events, total);
  EXPECT_GT(events, 0u);
  MeniscusMemoryStats stats{};
  stats.size = sizeof stats;
  ASSERT_EQ(meniscus_memory_stats(made, &stats), MENISCUS_OK);
  EXPECT_GT(stats.device.bytes, 1000u);
}

MENISCUS_ON_EACH_DEVICE(CHost);

}  // namespace
}  // namespace meniscus::tests
