// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A recording repeats a run bit for bit, whatever calls it has.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "sdk/world/recording/record_file.h"
#include "sdk/world/recording/replayed_calls.h"
#include "sdk/world/state/chunk_file.h"
#include "tests/cloth_worlds.h"
#include "tests/expect_error.h"
#include "tests/many_threads.h"
#include "tests/unit/sdk/world/recording/all_calls.h"
#include "tests/unit/sdk/world/snapshot/cases.h"

namespace meniscus::tests {
namespace {

namespace fs = std::filesystem;

class RecordingTest : public OnDevice {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path() const { return (folder_ / "run.menisrec").string(); }

  std::string read() const {
    std::ifstream file(path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// Of all that is in a world, but not of the world itself.
  std::string definitions_of(const World& world) const {
    const std::string file = (folder_ / "state.menisnap").string();
    world.save(file);
    ChunkFileHeader header;
    read_chunk_file(file, header);
    call_text::Json all = call_text::Json::parse(header.definitions);
    all.erase("world");
    return all.dump();
  }
  void write(const std::string& bytes) const { std::ofstream(path(), std::ios::binary) << bytes; }

  /// Replays all steps; each has the hash of the recorded one.
  int replayed(Replay& replay, World& world) const {
    int steps = 0;
    while (const std::optional<ReplayStep> step = replay.next(world)) {
      EXPECT_EQ(step->hash, step->recorded_hash) << "step " << steps;
      ++steps;
    }
    return steps;
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("meniscus_recordings_" + std::to_string(getpid()));
};

TEST_P(RecordingTest, RepeatsWorldsInTheMidstOfSomething) {
  const ManyThreads many;
  for (const SnapshotCase& c : snapshot_cases()) {
    SCOPED_TRACE(c.name);
    WorldDef def = world_def(GetParam(), 0.05f);
    def.threads = 1;
    World world = c.make(def);
    run(world, c.before, snapshot_step);
    world.start_recording(path());
    run(world, 2, snapshot_step);
    world.stop_recording();
    Replay replay(path());
    EXPECT_EQ(replay.device(), world.device().kind);
    LoadDef several;
    several.threads = 3;
    World again = replay.start(several);
    EXPECT_EQ(replayed(replay, again), 2);
    EXPECT_TRUE(replay.is_complete());
    EXPECT_EQ(state_of(again), state_of(world));
  }
}

TEST_P(RecordingTest, RepeatsEachCall) {
  World world = make_for_all_calls(world_def(GetParam(), 0.1f));
  world.start_recording(path());
  make_all_calls(world);
  world.stop_recording();
  std::set<std::string> made;
  RecordReader reader(path());
  while (const std::optional<Record> record = reader.next()) {
    if (record->kind == RecordKind::call)
      made.insert(call_text::Json::from_cbor(record->bytes)[0].get<std::string>());
  }
  for (const auto& [name, call] : replayed_calls()) EXPECT_TRUE(made.count(name)) << name;
  Replay replay(path());
  World again = replay.start();
  EXPECT_GT(replayed(replay, again), 5);
  EXPECT_TRUE(replay.is_complete());
  EXPECT_EQ(state_of(again), state_of(world));
}

TEST_P(RecordingTest, TellsWhichCallsChangeDefinitions) {
  World world = make_for_all_calls(world_def(GetParam(), 0.1f));
  world.start_recording(path());
  make_all_calls(world);
  world.stop_recording();
  World again = Replay(path()).start();
  const call_text::Ids ids{again.fluid_ids().front().generation};
  std::string before = definitions_of(again);
  RecordReader reader(path());
  int changes = 0;
  while (const std::optional<Record> record = reader.next()) {
    if (record->kind != RecordKind::call) {
      EXPECT_FALSE(changes_definitions(*record));
      continue;
    }
    const call_text::Json call = call_text::Json::from_cbor(record->bytes, true, false);
    const auto name = call[0].get<std::string>();
    if (is_step(*record))
      again.step(call_text::decode<float>(call[1], ids), call_text::decode<int>(call[2], ids));
    else
      replayed_calls().at(name)(again, call, ids);
    const std::string after = definitions_of(again);
    EXPECT_TRUE(changes_definitions(*record) || after == before) << name;
    changes += after != before;
    before = after;
  }
  EXPECT_GT(changes, 10);
  EXPECT_EQ(state_of(again), state_of(world));
}

TEST_P(RecordingTest, HasTheIterationsOfABudget) {
  WorldDef def = world_def(GetParam(), 0.1f);
  def.step_budget_ms = 1e-6f;
  World world = dam_break(def);
  world.start_recording(path());
  std::vector<int> chosen;
  for (int k = 0; k < 3; ++k) chosen.push_back(world.step(0.01f).iterations);
  world.stop_recording();
  Replay replay(path());
  World again = replay.start();
  for (const int iterations : chosen) EXPECT_EQ(replay.next(again)->report.iterations, iterations);
}

TEST_P(RecordingTest, FollowsAWorldThatGoesBack) {
  World world = dam_break(GetParam(), 0.1f);
  const Snapshot start = world.snapshot();
  world.step(0.01f);
  world.start_recording(path());
  world.step_begin(0.01f);
  world.step_end();
  world.restore(start);
  world.step(0.01f);
  world.stop_recording();
  Replay replay(path());
  World again = replay.start();
  EXPECT_EQ(replayed(replay, again), 2);
  EXPECT_EQ(again.time(), world.time());
}

TEST_P(RecordingTest, TakesHooksAndProgressToTheWorldThatWentBack) {
  World world = dam_break(GetParam(), 0.1f);
  const Snapshot start = world.snapshot();
  world.start_recording(path());
  for (int k = 0; k < 2; ++k) {
    world.restore(start);
    world.step(0.01f);
  }
  world.stop_recording();
  Replay replay(path());
  World again = replay.start();
  int calls = 0, reports = 0;
  const HookId hook = again.add_hook(Hook::solved, [&](const SubstepView&) { ++calls; });
  again.set_progress([&](const Progress&) { ++reports; });
  ASSERT_TRUE(replay.next(again));
  EXPECT_GT(calls, 0);
  EXPECT_GT(reports, 0);
  std::vector<World> others;
  for (int k = 0; k < 3; ++k) {
    others.push_back(dam_break(GetParam(), 0.2f));
    EXPECT_NE(others.back().add_hook(Hook::solved, [](const SubstepView&) {}), hook);
  }
  again.remove_hook(hook);
  calls = 0;
  ASSERT_TRUE(replay.next(again));
  EXPECT_EQ(calls, 0);
}

TEST_P(RecordingTest, WarnsOfHooks) {
  WorldDef def = world_def(GetParam(), 0.2f);
  std::string warnings;
  def.log = [&](LogLevel level, const std::string& text) {
    if (level == LogLevel::warning) warnings += text;
  };
  World world = dam_break(def);
  world.add_hook(Hook::solved, [](const SubstepView&) {});
  EXPECT_EQ(warnings, "");
  world.start_recording(path());
  EXPECT_NE(warnings.find("hooks are in no recording"), std::string::npos);
  warnings.clear();
  world.add_hook(Hook::solved, [](const SubstepView&) {});
  EXPECT_NE(warnings.find("hooks are in no recording"), std::string::npos);
}

TEST_P(RecordingTest, LeavesOutCallsThatFail) {
  World world = dam_break(GetParam(), 0.1f);
  world.start_recording(path());
  EXPECT_THROW(world.create_shape(shape(SphereGeometry{-1}, {0, 0, 0})), Error);
  EXPECT_THROW(world.step(-1), Error);
  world.step(0.01f);
  world.stop_recording();
  Replay replay(path());
  World again = replay.start();
  EXPECT_EQ(replayed(replay, again), 1);
}

TEST_P(RecordingTest, IsGoodUpToWhereItWasCut) {
  World world = dam_break(GetParam(), 0.2f);
  world.start_recording(path());
  run(world, 3, 0.01f);
  world.stop_recording();
  const std::string whole = read();
  for (const size_t cut : {size_t{1}, size_t{24}, size_t{30}, size_t{80}, size_t{100}}) {
    write(whole.substr(0, whole.size() - cut));
    Replay replay(path());
    World again = replay.start();
    const int steps = replayed(replay, again);
    EXPECT_LE(steps, 3);
    EXPECT_GE(steps, 1);
    EXPECT_FALSE(replay.is_complete());
  }
  for (const size_t length : {0, 8, 20, 40}) {
    write(whole.substr(0, length));
    expect_error(ErrorCode::io, "no usable recording", [&] { Replay(path()).start(); });
  }
}

TEST_P(RecordingTest, RefusesAByteThatDiffers) {
  World world = dam_break(GetParam(), 0.2f);
  world.start_recording(path());
  run(world, 2, 0.01f);
  world.stop_recording();
  const std::string whole = read();
  for (size_t at = 0; at < whole.size(); at += 1 + whole.size() / 97) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    write(changed);
    try {
      Replay replay(path());
      World again = replay.start();
      replayed(replay, again);
      EXPECT_FALSE(replay.is_complete()) << "byte " << at;  // a length beyond the file reads as a cut
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::io) << "byte " << at;
    }
  }
}

/// The hashes are right: only the contents are not.
TEST_P(RecordingTest, RefusesACallThatIsNone) {
  World world = dam_break(GetParam(), 0.2f);
  world.start_recording(path());
  world.stop_recording();
  const std::optional<Record> state = RecordReader(path()).next();
  ASSERT_TRUE(state);
  using Bytes = std::vector<uint8_t>;
  using call_text::Json;
  Bytes trailing = Json::to_cbor(Json{"relax", 1});
  trailing.push_back(0);
  const std::vector<std::pair<const char*, Bytes>> calls{
      {"nested lists", Bytes(1'000'000, 0x81)},
      {"nested objects", Bytes(1'000'000, 0xa1)},
      {"nested texts", Bytes(1'000'000, 0x7f)},
      {"nested bytes", Bytes(1'000'000, 0x5f)},
      {"nested tags", Bytes(1'000'000, 0xc1)},
      {"lists of any length", Bytes(1'000'000, 0x9f)},
      {"a list of 2⁶⁴ − 1", {0x9b, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff}},
      {"a list beyond the end", {0x9b, 0x7f, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff}},
      {"an object beyond the end", {0xbb, 0x80, 0, 0, 0, 0, 0, 0, 1}},
      {"a text beyond the end", {0x7b, 0x7f, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff}},
      {"nothing", {}},
      {"half a number", {0x81, 0x19, 0x01}},
      {"a simple value", {0x81, 0xf8, 0x20}},
      {"a key that is no text", {0xa1, 0x01, 0x01}},
      {"more than one", trailing},
      {"a text", Json::to_cbor(Json("step"))},
      {"other arguments of step", Json::to_cbor(Json{"step", "x", nullptr, 1})},
      {"no arguments", Json::to_cbor(Json::array({"create_cloth"}))},
      {"other arguments", Json::to_cbor(Json{"create_cloth", {1, 2}})},
      {"a list for bytes", Json::to_cbor(Json{"remove_particles", 5})}};
  for (const auto& [what, bytes] : calls) {
    SCOPED_TRACE(what);
    RecordWriter writer(path(), {"", world.device().kind});
    writer.write(RecordKind::state, state->bytes);
    writer.write(RecordKind::call, bytes);
    Replay replay(path());
    World again = replay.start();
    expect_error(ErrorCode::io, "", [&] { replay.next(again); });
  }
}

TEST_P(RecordingTest, RefusesWhatCannotBe) {
  WorldDef def = world_def(GetParam(), 0.2f);
  int warnings = 0;
  def.log = [&](LogLevel level, const std::string&) { warnings += level == LogLevel::warning; };
  World world = dam_break(def);
  expect_error(ErrorCode::io, "no/such", [&] { world.start_recording("/no/such/folder/file"); });
  world.start_recording(path());
  expect_error(ErrorCode::invalid_argument, "is recorded", [&] { world.start_recording(path()); });
  world.step(0.01f);
  world.stop_recording();
  expect_error(ErrorCode::invalid_argument, "nothing is being recorded", [&] { world.stop_recording(); });
  EXPECT_EQ(warnings, 0);
}

MENISCUS_ON_EACH_DEVICE(RecordingTest);

}  // namespace
}  // namespace meniscus::tests
