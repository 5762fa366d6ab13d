// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A program's own loop in place of the library's threads: the results are the same.
#include <atomic>
#include <thread>

#include "tests/expect_error.h"
#include "tests/many_threads.h"
#include "tests/unit/sdk/world/snapshot/cases.h"

namespace meniscus::tests {
namespace {

/// Threads of the program that take pieces in any order.
ParallelFor loop_on(unsigned threads, uint32_t piece, std::atomic<uint64_t>& loops) {
  return [=, &loops](uint32_t count, uint32_t grain, const LoopBody& body) {
    ++loops;
    const uint32_t size = std::max(grain, piece);
    std::atomic<uint32_t> next = 0;
    const auto work = [&] {
      for (uint32_t begin; (begin = next.fetch_add(size)) < count;)
        body(begin, std::min(begin + size, count));
    };
    std::vector<std::thread> helpers;
    for (unsigned k = 1; k < threads; ++k) helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) helper.join();
  };
}

TEST(ThreadsOfTheProgram, GiveTheSameResults) {
  for (const char* name : {"fluids", "wet"}) {
    for (const SnapshotCase& c : snapshot_cases()) {
      if (c.name != std::string(name)) continue;
      WorldDef def = world_def(pbd::DeviceKind::cpu, 0.05f);
      def.threads = 1;
      World own = c.make(def);
      std::atomic<uint64_t> loops = 0;
      def.threads = 0;
      def.parallel_for = loop_on(3, 1000, loops);
      World theirs = c.make(def);
      EXPECT_EQ(theirs.device().name, "CPU, threads of the program");
      run(own, 3, snapshot_step);
      run(theirs, 3, snapshot_step);
      EXPECT_EQ(state_of(theirs), state_of(own)) << name;
      EXPECT_GT(loops, 100u);
    }
  }
}

TEST(ThreadsOfTheProgram, GoWithAFile) {
  std::atomic<uint64_t> loops = 0;
  World world = dam_break(pbd::DeviceKind::cpu, 0.1f);
  LoadDef def;
  def.parallel_for = loop_on(2, 1, loops);
  World clone = world.clone(def);
  run(world, 2, 0.01f);
  run(clone, 2, 0.01f);
  EXPECT_GT(loops, 0u);
  EXPECT_EQ(clone.state_hash(), world.state_hash());
}

TEST(ThreadsOfTheProgram, ExcludeANumberOfThreads) {
  WorldDef def = world_def(pbd::DeviceKind::cpu, 0.1f);
  def.threads = 2;
  def.parallel_for = [](uint32_t count, uint32_t, const LoopBody& body) { body(0, count); };
  expect_error(ErrorCode::invalid_argument, "threads", [&] { const World world(def); });
}

/// The statement of world.h: worlds share nothing, and any thread may cancel. The thread sanitizer looks on.
TEST(ThreadsOfTheProgram, WorldsOnThreadsOfTheirOwnShareNothing) {
  World expected = dam_break(pbd::DeviceKind::cpu, 0.1f);
  run(expected, 3, 0.01f);
  std::vector<uint64_t> hashes(3);
  std::vector<std::thread> threads;
  for (uint64_t& hash : hashes) {
    threads.emplace_back([&hash] {
      WorldDef def = world_def(pbd::DeviceKind::cpu, 0.1f);
      def.threads = 2;
      World world = dam_break(def);
      run(world, 2, 0.01f);
      World clone = world.clone();
      clone.step(0.01f);
      hash = clone.state_hash();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const uint64_t hash : hashes) EXPECT_EQ(hash, expected.state_hash());
}

TEST(ThreadsOfTheProgram, AnyThreadCancels) {
  World world = dam_break(pbd::DeviceKind::cpu, 0.05f);
  std::atomic<bool> done = false;
  std::thread other([&] {
    while (!done) world.cancel();
  });
  int cancelled = 0;
  for (int k = 0; k < 5; ++k) {
    try {
      world.step(0.01f);
    } catch (const Error& error) {
      cancelled += error.code() == ErrorCode::cancelled;
    }
  }
  done = true;
  other.join();
  EXPECT_GT(cancelled, 0);
}

/// A read-out that is held may be released on any thread, while the world writes the next one.
TEST(ThreadsOfTheProgram, AnyThreadReleasesAReadOut) {
  World world = dam_break(pbd::DeviceKind::cpu, 0.1f);
  for (int k = 0; k < 3; ++k) {
    const std::span<const Vec3> positions = world.positions();
    std::thread other([held = world.hold(positions.data()), positions, first = positions[0]] {
      EXPECT_EQ(positions[0], first);
    });
    world.step(0.01f);
    world.positions();
    other.join();
  }
}

}  // namespace
}  // namespace meniscus::tests
