// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A world from a file goes on bit for bit, and a file with any byte changed is refused.
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/expect_error.h"
#include "tests/many_threads.h"
#include "tests/unit/sdk/world/snapshot/cases.h"

namespace meniscus::tests {
namespace {

namespace fs = std::filesystem;

constexpr int steps = 3;

class SnapshotFileTest : public OnDevice {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path() const { return (folder_ / "world.menisnap").string(); }

  static std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static void write(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("meniscus_snapshots_" + std::to_string(getpid()));
};

TEST_P(SnapshotFileTest, TheFutureIsTheSame) {
  const ManyThreads many;
  for (const SnapshotCase& c : snapshot_cases()) {
    SCOPED_TRACE(c.name);
    WorldDef def = world_def(GetParam(), 0.05f);
    def.threads = 1;
    World world = c.make(def);
    run(world, c.before, snapshot_step);
    world.save(path());
    const auto then = state_of(world);
    const auto future = future_of(world, steps);
    LoadDef several;
    several.threads = 3;
    World loaded = World::load(path(), several);
    EXPECT_EQ(loaded.def().threads, 3);
    EXPECT_EQ(state_of(loaded), then);
    loaded.save(path());
    EXPECT_EQ(future_of(loaded, steps), future);
    EXPECT_EQ(future_of(world = World::load(path()), steps), future) << "saved again";
  }
}

/// What was created before goes on by the same definitions, and what comes after gets the next ids.
TEST_P(SnapshotFileTest, IsAWorldLikeAnyOther) {
  const auto make = [&] {
    World world = dam_break(GetParam());
    const BodyId gone = world.create_body({});
    world.destroy_body(gone);
    run(world, 3, snapshot_step);
    return world;
  };
  const auto go_on = [](World& world) {
    BodyDef ball;
    ball.name = "ball";
    ball.geometry = SphereGeometry{0.1f};
    ball.pose.position = {0.8f, 0.5f, 0.25f};
    const BodyId id = world.create_body(ball);
    world.add_fluid(block(world.fluid_ids()[0], {0.6f, 0.8f, 0}, {0.9f, 0.95f, 0.3f}));
    run(world, 3, snapshot_step);
    EXPECT_EQ(world.find_body("ball"), id);
    return world.state_hash();
  };
  World world = make();
  world.save(path());
  World loaded = World::load(path());
  EXPECT_EQ(go_on(loaded), go_on(world));
  const Snapshot snapshot = loaded.snapshot();
  loaded.step(snapshot_step);
  loaded.restore(snapshot);
  EXPECT_EQ(loaded.state_hash(), world.state_hash());
}

TEST_P(SnapshotFileTest, ACloneGoesItsOwnWay) {
  World world = snapshot_cases()[2].make(world_def(GetParam(), 0.1f));
  run(world, 5, snapshot_step);
  World clone = world.clone();
  EXPECT_EQ(state_of(clone), state_of(world));
  const BodyId body = clone.find_body("late");
  expect_error(ErrorCode::not_found, "no body", [&] { world.body_state(body); });
  EXPECT_EQ(future_of(clone, 2), future_of(world, 2));
  clone.apply_force(body, {0, 0, 50});
  EXPECT_NE(future_of(clone, 1), future_of(world, 1));
}

TEST_P(SnapshotFileTest, RefusesAFileThatWasCut) {
  World world(world_def(GetParam(), 0.1f));
  const FluidId water = world.create_fluid({});
  world.add_fluid(block(water, {0, 0, 0}, {0.3f, 0.3f, 0.3f}));
  world.save(path());
  const std::string whole = read(path());
  for (size_t k = 0; k < 60; ++k) {
    write(path(), whole.substr(0, whole.size() * k / 60));
    expect_error(ErrorCode::io, "no usable snapshot", [&] { World::load(path()); });
  }
  write(path(), whole + "x");
  expect_error(ErrorCode::io, "after its end", [&] { World::load(path()); });
  write(path(), whole);
  EXPECT_EQ(World::load(path()).state_hash(), world.state_hash());
}

/// At the beginning of each chunk, and within each.
TEST_P(SnapshotFileTest, RefusesAFileThatWasCutAtAnyChunk) {
  World world = snapshot_cases()[2].make(world_def(GetParam(), 0.1f));
  run(world, 2, snapshot_step);
  world.save(path());
  const std::string whole = read(path());
  uint32_t length = 0;
  std::memcpy(&length, whole.data() + 12, sizeof length);
  const auto header = nlohmann::json::parse(whole.substr(24, length));
  size_t at = 24 + length, chunks = 0;
  for (const auto& chunk : header.at("chunks")) {
    const size_t bytes = chunk.at("element_bytes").get<size_t>() * chunk.at("count").get<size_t>();
    const std::string expected = "ends within the chunk \"" + chunk.at("name").get<std::string>() + '"';
    if (bytes == 0) continue;
    for (const size_t cut : {at, at + bytes / 2}) {
      write(path(), whole.substr(0, cut));
      expect_error(ErrorCode::io, expected, [&] { World::load(path()); });
    }
    at += bytes;
    ++chunks;
  }
  EXPECT_EQ(at, whole.size());
  EXPECT_GT(chunks, 50u);
}

TEST_P(SnapshotFileTest, FindsEachChangedByteOfTheHeader) {
  World world(world_def(GetParam(), 0.1f));
  world.save(path());
  const std::string bytes = read(path());
  uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof length);
  const size_t header = 24 + length;
  std::fstream file(path(), std::ios::binary | std::ios::in | std::ios::out);
  const auto put = [&](size_t at, char byte) {
    file.seekp(static_cast<std::streamoff>(at)).put(byte).flush();
  };
  for (size_t k = 0; k < header; ++k) {
    put(k, static_cast<char>(bytes[k] ^ (1 << k % 8)));
    expect_error(ErrorCode::io, "no usable snapshot", [&] { World::load(path()); });
    put(k, bytes[k]);
  }
}

TEST_P(SnapshotFileTest, FindsAnyChangedBit) {
  World world = snapshot_cases()[3].make(world_def(GetParam(), 0.1f));
  run(world, 2, snapshot_step);
  world.save(path());
  const std::string bytes = read(path());
  std::mt19937 random(7);
  for (int k = 0; k < 60; ++k) {
    std::string changed = bytes;
    const size_t at = random() % changed.size();
    changed[at] = static_cast<char>(changed[at] ^ (1 << random() % 8));
    write(path(), changed);
    expect_error(ErrorCode::io, "no usable snapshot", [&] { World::load(path()); });
  }
}

TEST_P(SnapshotFileTest, NamesAFileThatCannotBeUsed) {
  World world(world_def(GetParam(), 0.1f));
  expect_error(ErrorCode::io, "cannot read", [&] { World::load((folder_ / "none").string()); });
  expect_error(ErrorCode::io, "cannot write", [&] { world.save((folder_ / "none" / "x").string()); });
  write(path(), "{}, and much more that is a file of another kind");
  expect_error(ErrorCode::io, "does not begin with MENISNAP", [&] { World::load(path()); });
  world.save(path());
  size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder_)) files += entry.exists();
  EXPECT_EQ(files, 1u) << "something else remains";
}

TEST_P(SnapshotFileTest, ReplacesAFileAndIsAsReadableAsOthers) {
  const std::string other = (folder_ / "other").string();
  write(other, "a file that is kept");
  fs::create_symlink(other, path());
  const World world(world_def(GetParam(), 0.1f));
  world.save(path());
  EXPECT_FALSE(fs::is_symlink(path())) << "the link is replaced, not followed";
  EXPECT_EQ(read(other), "a file that is kept");
  EXPECT_EQ(fs::status(path()).permissions(), fs::status(other).permissions());
}

MENISCUS_ON_EACH_DEVICE(SnapshotFileTest);

}  // namespace
}  // namespace meniscus::tests
