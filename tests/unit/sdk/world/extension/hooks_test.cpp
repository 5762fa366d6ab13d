// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Calls of the user within a substep.
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/expect_error.h"
#include "tests/unit/sdk/world/extension/device_memory.h"
#include "tests/unit/sdk/world/extension/force_worlds.h"

namespace meniscus::tests {
namespace {

class HooksTest : public OnDevice {};

TEST_P(HooksTest, AreCalledInOrder) {
  WorldDef def = world_def(GetParam(), 0.1f);
  def.substeps = 2;
  def.iterations = 3;
  World world = dam_break(def);
  world.create_cloth(sheet(0.2f, 0.2f, 3, 3, {0.3f, 0.95f, 0.25f}));
  std::vector<std::pair<Hook, int>> calls;
  const auto note = [&](const SubstepView& view) {
    calls.emplace_back(view.hook, view.iteration);
    EXPECT_EQ(view.particles, world.particle_count());
    EXPECT_EQ(view.vertices, 9u);
    EXPECT_NEAR(view.dt, 0.005f, 1e-9f);
    EXPECT_EQ(view.on_cuda, GetParam() == pbd::DeviceKind::cuda);
    EXPECT_EQ(view.previous == nullptr, view.hook == Hook::velocities_known);
  };
  for (uint32_t hook = 0; hook < hook_count; ++hook) world.add_hook(static_cast<Hook>(hook), note);
  world.step(0.01f);
  using enum Hook;
  const std::vector<std::pair<Hook, int>> substep{{predicted, 0},       {contacts_found, 0}, {iterated, 0},
                                                  {iterated, 1},        {iterated, 2},       {solved, 0},
                                                  {velocities_known, 0}};
  std::vector<std::pair<Hook, int>> expected = substep;
  expected.insert(expected.end(), substep.begin(), substep.end());
  // A step that found no room for all contacts runs again.
  ASSERT_EQ(calls.size() % expected.size(), 0u);
  for (size_t k = 0; k < calls.size(); ++k) EXPECT_EQ(calls[k], expected[k % expected.size()]) << k;
}

TEST_P(HooksTest, ThatOnlyLookChangeNothing) {
  World plain = dam_break(GetParam(), 0.1f), watched = dam_break(GetParam(), 0.1f);
  for (uint32_t hook = 0; hook < hook_count; ++hook)
    watched.add_hook(static_cast<Hook>(hook), [](const SubstepView&) {});
  run(plain, 10, 0.01f);
  run(watched, 10, 0.01f);
  EXPECT_EQ(watched.state_hash(), plain.state_hash());
}

TEST_P(HooksTest, CanBeAForce) {
  OneOfEach hooked(weightless(GetParam())), pulled(weightless(GetParam()));
  pulled.world.create_force_field(field(UniformForce{{0, 3, 0}}));
  hooked.world.add_hook(Hook::velocities_known, [](const SubstepView& view) {
    add_y(view.velocities, view.particles, 3 * view.dt, view);
  });
  run(hooked.world, 20, 0.01f);
  run(pulled.world, 20, 0.01f);
  for (size_t k = 0; k < 2; ++k) expect_near(hooked.velocities()[k], pulled.velocities()[k], 1e-6f);
}

TEST_P(HooksTest, CanMovePositions) {
  OneOfEach all(weightless(GetParam(), 1));
  all.world.add_hook(Hook::iterated, [](const SubstepView& view) {
    add_y(view.positions, view.particles, 0.001f, view);
    add_y(view.corrections, view.particles, 0.001f, view);
  });
  all.world.step(0.01f);
  expect_near(all.world.positions()[0], {0, 0.002f, 0}, 1e-6f);
  expect_near(all.world.velocities()[0], {0, 0.2f, 0}, 1e-5f, "the velocity follows");
}

TEST_P(HooksTest, AreCalledInTheOrderOfTheirAdditionAndCanBeRemoved) {
  World world = dam_break(GetParam(), 0.1f);
  world.step(0.01f);  // with room for all contacts from here on
  std::string calls;
  const HookId a = world.add_hook(Hook::solved, [&](const SubstepView&) { calls += 'a'; });
  const HookId b = world.add_hook(Hook::solved, [&](const SubstepView&) { calls += 'b'; });
  world.step(0.01f);
  EXPECT_EQ(calls, "abababab");
  calls.clear();
  world.remove_hook(a);
  const HookId c = world.add_hook(Hook::predicted, [&](const SubstepView&) { calls += 'c'; });
  world.step(0.01f);
  EXPECT_EQ(calls, "cbcbcbcb");
  expect_error(ErrorCode::not_found, "no hook", [&] { world.remove_hook(a); });
  calls.clear();
  world.remove_hook(b);
  world.remove_hook(c);
  world.step(0.01f);
  EXPECT_TRUE(calls.empty());
  const auto look = [](const SubstepView&) {};
  expect_error(ErrorCode::invalid_argument, "add_hook", [&] { world.add_hook(static_cast<Hook>(5), look); });
  expect_error(ErrorCode::invalid_argument, "empty", [&] { world.add_hook(Hook::solved, {}); });
}

TEST_P(HooksTest, HaveIdsThatNoOtherLivingWorldHas) {
  World a = dam_break(GetParam(), 0.2f), b = dam_break(GetParam(), 0.2f);
  int calls = 0;
  const HookId of_a = a.add_hook(Hook::solved, [](const SubstepView&) {});
  b.add_hook(Hook::solved, [&](const SubstepView&) { ++calls; });
  expect_error(ErrorCode::not_found, "no hook", [&] { b.remove_hook(of_a); });
  b.step(0.01f);
  EXPECT_GT(calls, 0);
  a.remove_hook(of_a);
}

TEST_P(HooksTest, AnExceptionLeavesTheStateBeforeTheStep) {
  World world = dam_break(GetParam(), 0.1f);
  run(world, 2, 0.01f);
  const uint64_t before = world.state_hash();
  int calls = 0;
  const HookId hook = world.add_hook(Hook::contacts_found, [&](const SubstepView&) {
    if (++calls == 3) throw std::runtime_error("enough");
  });
  EXPECT_THROW(world.step(0.01f), std::runtime_error);
  EXPECT_EQ(world.state_hash(), before);
  world.remove_hook(hook);
  World other = dam_break(GetParam(), 0.1f);
  run(other, 3, 0.01f);
  world.step(0.01f);
  EXPECT_EQ(world.state_hash(), other.state_hash());
}

MENISCUS_ON_EACH_DEVICE(HooksTest);

}  // namespace
}  // namespace meniscus::tests
