// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The iterations of a step: by a budget of time, and as given.
#include <algorithm>
#include <numeric>

#include "sdk/world/host/step_budget.h"
#include "tests/expect_error.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

StepReport report_of(int iterations, double solve_ms) {
  StepReport report;
  report.iterations = iterations;
  report.stage_ms[static_cast<size_t>(Stage::solve)] = solve_ms;
  return report;
}

TEST(StepBudget, FitsTheIterationsIntoTheTime) {
  StepBudget budget;
  EXPECT_EQ(budget.choose(1, 10), 10) << "nothing is known before the first step";
  budget.note(report_of(10, 20), 25);  // 5 ms beside, and 2 ms each
  EXPECT_EQ(budget.choose(0, 10), 10) << "no budget";
  EXPECT_EQ(budget.choose(15.1, 10), 5);
  EXPECT_EQ(budget.choose(24.9, 10), 9);
  EXPECT_EQ(budget.choose(100, 10), 10);
  EXPECT_EQ(budget.choose(1, 10), 1) << "at least one";
}

class StepBudgetTest : public OnDevice {};

TEST_P(StepBudgetTest, LeavesOutIterationsAndTellsSo) {
  WorldDef def = world_def(GetParam(), 0.1f);
  def.iterations = 50;
  def.step_budget_ms = 1e-6f;
  World world = dam_break(def);
  EXPECT_EQ(world.step(0.01f).iterations, 50);
  EXPECT_EQ(world.step(0.01f).iterations, 1);
  def.step_budget_ms = 0;
  world.set_def(def);
  EXPECT_EQ(world.step(0.01f).iterations, 50);
}

TEST_P(StepBudgetTest, IsRepeatedByTheNumbersOfIterations) {
  WorldDef def = world_def(GetParam(), 0.1f);
  World plain = dam_break(def);
  def.step_budget_ms = 1e-6f;
  World hurried = dam_break(def);
  std::vector<int> chosen;
  for (int k = 0; k < 3; ++k) chosen.push_back(hurried.step(0.01f).iterations);
  for (const int iterations : chosen) EXPECT_EQ(plain.step(0.01f, iterations).iterations, iterations);
  EXPECT_EQ(plain.state_hash(), hurried.state_hash());
}

TEST_P(StepBudgetTest, AGivenNumberIsThatOfTheDefinition) {
  WorldDef few = world_def(GetParam(), 0.1f), many = few;
  few.iterations = 3;
  many.iterations = 12;
  World a = dam_break(few), b = dam_break(many);
  a.step(0.01f);
  b.step(0.01f, 3);
  EXPECT_EQ(a.state_hash(), b.state_hash());
  a.step(0.01f, 12);
  b.step_begin(0.01f);
  b.step_end();
  EXPECT_EQ(a.state_hash(), b.state_hash());
  expect_error(ErrorCode::invalid_argument, "iterations", [&] { a.step(0.01f, 0); });
  EXPECT_EQ(a.state_hash(), b.state_hash());
}

MENISCUS_ON_EACH_DEVICE(StepBudgetTest);

/// The bar is 50 µs for a thousand particles on the CPU. Parts of the solver lie outside of its stages, so
/// this measures too much.
TEST(StepOverhead, IsSmall) {
#if !defined(__OPTIMIZE__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "for optimised programs";
#endif
  WorldDef def = world_def(pbd::DeviceKind::cpu, 0.1f);
  def.threads = 1;
  def.substeps = def.iterations = 1;
  World world(def);
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {1, 1, 1}));
  ASSERT_EQ(world.add_fluid(block(water, {0, 0, 0}, {1, 1, 1})), 1000u);
  double least = 1;  // ms
  for (int k = 0; k < 200; ++k) {
    const StepReport report = world.step(1e-3f);
    least = std::min(least, report.ms - std::accumulate(report.stage_ms.begin(), report.stage_ms.end(), 0.0));
  }
  EXPECT_LT(least, 0.05);
}

class MemoryStatsTest : public OnDevice {};

TEST_P(MemoryStatsTest, CountWhatIsHeld) {
  World world = dam_break(GetParam(), 0.1f);
  run(world, 3, 0.01f);
  const MemoryStats warm = world.memory_stats();
  EXPECT_EQ(warm.device.bytes, world.device_bytes());
  EXPECT_GE(warm.device.peak_bytes, warm.device.bytes);
  EXPECT_GT(warm.device.allocations, 10u);
  EXPECT_GT(warm.shared.bytes, 0u);
  world.step(0.01f);
  EXPECT_EQ(world.memory_stats().device.allocations, warm.device.allocations)
      << "a warm step allocates nothing";
  {
    const Snapshot snapshot = world.snapshot();
    EXPECT_EQ(world.memory_stats().device.bytes, warm.device.bytes + snapshot.device_bytes());
  }
  EXPECT_EQ(world.memory_stats().device.bytes, warm.device.bytes);
}

MENISCUS_ON_EACH_DEVICE(MemoryStatsTest);

}  // namespace
}  // namespace meniscus::tests
