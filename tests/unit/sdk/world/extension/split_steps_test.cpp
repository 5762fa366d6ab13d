// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Steps in two halves.
#include <gtest/gtest.h>

#include "tests/expect_error.h"
#include "tests/unit/sdk/world/extension/force_worlds.h"
#include "tests/unit/sdk/world/snapshot/cases.h"

namespace meniscus::tests {
namespace {

class SplitStepsTest : public OnDevice {
 protected:
  World make() const {
    World world = dam_break(GetParam(), 0.1f);
    world.create_body(brick({0.7f, 0.6f, 0.25f}));
    world.create_cloth(sheet(0.3f, 0.3f, 4, 4, {0.3f, 0.95f, 0.25f}));
    return world;
  }
};

TEST_P(SplitStepsTest, AreTheSameSteps) {
  World whole = make(), split = make();
  for (int k = 0; k < 8; ++k) {
    const StepReport one = whole.step(snapshot_step);
    split.step_begin(snapshot_step);
    const StepReport two = split.step_end();
    EXPECT_EQ(one.contacts, two.contacts);
    EXPECT_EQ(one.substeps, two.substeps);
    EXPECT_EQ(state_of(whole), state_of(split));
  }
}

TEST_P(SplitStepsTest, OtherCallsInBetweenAreRefusedByName) {
  World world = make();
  world.step_begin(0.01f);
  const auto refused = [&](const char* name, const auto& call) {
    expect_error(ErrorCode::invalid_argument, name, call);
  };
  refused("positions was called between", [&] { world.positions(); });
  refused("create_fluid was called between", [&] { world.create_fluid({}); });
  refused("step was called between", [&] { world.step(0.01f); });
  refused("step_begin was called between", [&] { world.step_begin(0.01f); });
  refused("destroy_body was called between", [&] { world.destroy_body(BodyId{}); });
  refused("snapshot was called between", [&] { world.snapshot(); });
  world.step_end();
  EXPECT_NEAR(world.time(), 0.01, 1e-9);
  World other = make();
  other.step(0.01f);
  EXPECT_EQ(state_of(other), state_of(world));
}

TEST_P(SplitStepsTest, AnEndNeedsABeginning) {
  World world = make();
  expect_error(ErrorCode::invalid_argument, "step_begin", [&] { world.step_end(); });
  world.step(0.01f);
  EXPECT_THROW(world.step_begin(-1), Error);
  expect_error(ErrorCode::invalid_argument, "step_begin", [&] { world.step_end(); });
}

TEST_P(SplitStepsTest, AFailureAtTheEndRestoresTheState) {
  World world = make();
  world.step(0.01f);
  const uint64_t before = world.state_hash();
  world.create_force_field(field(UniformForce{{3e38f, 3e38f, 0}}));
  try {
    world.step_begin(1);
    world.step_end();
    ADD_FAILURE() << "the step should have failed";
  } catch (const Error&) {
  }
  EXPECT_EQ(world.state_hash(), before);
}

TEST_P(SplitStepsTest, AWorldMayGoInBetween) {
  World world = make();
  world.step_begin(0.01f);
}

MENISCUS_ON_EACH_DEVICE(SplitStepsTest);

}  // namespace
}  // namespace meniscus::tests
