// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a world says to its log, and how often.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

using Messages = std::vector<std::pair<LogLevel, std::string>>;

std::ptrdiff_t count_of(const Messages& messages, LogLevel level, const std::string& text) {
  return std::count_if(messages.begin(), messages.end(), [&](const auto& m) {
    return m.first == level && m.second.find(text) != std::string::npos;
  });
}

class LogTest : public OnDevice {
 protected:
  WorldDef logged(float spacing) {
    WorldDef def = world_def(GetParam(), spacing);
    def.log = [this](LogLevel level, const std::string& text) { messages_.emplace_back(level, text); };
    return def;
  }

  Messages messages_;
};

TEST_P(LogTest, NamesTheDevice) {
  const World world(logged(0.1f));
  ASSERT_EQ(messages_.size(), 1u);
  EXPECT_EQ(count_of(messages_, LogLevel::note, world.device().name), 1);
}

TEST_P(LogTest, HasTheWarningsOnceBeforeTheFirstStep) {
  World world(logged(0.1f));
  world.create_fluid({});
  BodyDef box;
  box.name = "first";
  world.create_body(box);
  box.name = "second";
  box.pose.position = {0.1f, 0, 0};
  world.create_body(box);
  EXPECT_EQ(count_of(messages_, LogLevel::warning, ""), 0);
  const std::vector<std::string> warnings = world.warnings();
  ASSERT_EQ(warnings.size(), 1u);
  run(world, 3, 1e-4f);
  EXPECT_EQ(count_of(messages_, LogLevel::warning, ""), 1);
  EXPECT_EQ(count_of(messages_, LogLevel::warning, warnings[0]), 1);
}

TEST_P(LogTest, SaysOnceThatAStepLeftSomethingOut) {
  WorldDef def = logged(0.1f);
  World world(def);
  EmitterDef jet;
  jet.fluid = world.create_fluid({});
  jet.opening = RectangleOpening{0.3f, 0.3f};
  jet.speed = 5;
  world.create_shape(shape(BoxGeometry{{1, 0.1f, 1}}, {0, 0.12f, 0}));  // no room in front of the opening
  world.create_emitter(jet);
  double refused = 0;
  for (int k = 0; k < 4; ++k) refused += world.step(0.02f).emission_refused;
  ASSERT_GT(refused, 0);
  EXPECT_EQ(count_of(messages_, LogLevel::warning, "no room"), 1);
}

TEST_P(LogTest, AThrowingSinkEndsNoCall) {
  WorldDef def = world_def(GetParam(), 0.1f);
  def.log = [](LogLevel, const std::string&) { throw std::runtime_error("full"); };
  World world = dam_break(def);
  EXPECT_NO_THROW(world.step(0.01f));
}

MENISCUS_ON_EACH_DEVICE(LogTest);

}  // namespace
}  // namespace meniscus::tests
