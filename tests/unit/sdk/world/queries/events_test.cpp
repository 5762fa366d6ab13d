// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Events of bodies that sleep and wake, and of particles that come and go.
#include <map>
#include <set>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class EventsTest : public OnDevice {};

TEST_P(EventsTest, ABodyFallsAsleepAndWakesOnce) {
  World world(world_def(GetParam(), 0.1f));
  world.create_shape(shape(PlaneGeometry{}, {0, 0, 0}));
  BodyDef box;
  box.geometry = BoxGeometry{{0.1f, 0.1f, 0.1f}};
  box.pose.position = {0, 0.1f, 0};
  const BodyId body = world.create_body(box);
  std::vector<SleepEvent> seen;
  const auto step = [&] {
    const bool before = world.body_state(body).awake;
    world.step(0.02f);
    const std::vector<SleepEvent>& events = world.sleep_events();
    const bool changed = world.body_state(body).awake != before;
    EXPECT_EQ(events.size(), changed ? 1u : 0u);
    seen.insert(seen.end(), events.begin(), events.end());
  };
  for (int k = 0; k < 200 && seen.empty(); ++k) step();
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].body, body);
  EXPECT_FALSE(seen[0].awake);
  for (int k = 0; k < 5; ++k) step();
  EXPECT_EQ(seen.size(), 1u);
  const Snapshot asleep = world.snapshot();
  world.apply_impulse(body, {0, 1, 0}, {0, 0.1f, 0});
  world.step(0.02f);
  ASSERT_EQ(world.sleep_events().size(), 1u);
  EXPECT_TRUE(world.sleep_events()[0].awake) << "woken by a call";
  world.step(0.02f);
  EXPECT_TRUE(world.sleep_events().empty());
  world.restore(asleep);
  world.step(0.02f);
  EXPECT_TRUE(world.sleep_events().empty()) << "it sleeps on";
}

TEST_P(EventsTest, EachParticleOfSinksAndEmittersIsTold) {
  World world(world_def(GetParam(), 0.05f));
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {0.6f, 1, 0.6f}));
  world.add_fluid(block(water, {0, 0, 0}, {0.6f, 0.15f, 0.6f}));
  EmitterDef jet;
  jet.fluid = water;
  jet.opening = DiscOpening{0.1f};
  jet.pose = {{0.3f, 0.7f, 0.3f}, about_z(180)};
  jet.speed = 2;
  const EmitterId emitter = world.create_emitter(jet);
  SinkDef drain;
  drain.region = BoxRegion{{0, 0, 0}, {0.2f, 0.1f, 0.2f}};
  const SinkId first = world.create_sink(drain);
  drain.region = BoxRegion{{0.4f, 0, 0.4f}, {0.6f, 0.1f, 0.6f}};
  const SinkId second = world.create_sink(drain);
  std::set<ParticleId> there(world.ids().begin(), world.ids().end());
  uint64_t gone = 0;
  for (int k = 0; k < 20; ++k) {
    world.step(0.01f);
    std::map<uint32_t, uint32_t> by_sink;
    uint32_t made = 0;
    for (const FlowEvent& event : world.flow_events()) {
      if (event.emitter == emitter) {
        EXPECT_TRUE(there.insert(event.particle).second);
        ++made;
      } else {
        EXPECT_EQ(there.erase(event.particle), 1u);
        ++by_sink[event.sink.index];
        ++gone;
      }
    }
    EXPECT_EQ(made, world.emitter_count(emitter).last_step);
    EXPECT_EQ(by_sink[first.index], world.sink_count(first).last_step);
    EXPECT_EQ(by_sink[second.index], world.sink_count(second).last_step);
    EXPECT_EQ(there, std::set<ParticleId>(world.ids().begin(), world.ids().end()));
  }
  EXPECT_GT(gone, 0u);
  EXPECT_GT(world.emitter_count(emitter).total, 0u);
}

TEST_P(EventsTest, AnImposedEmitterTellsOfLayersThatHavePassed) {
  World world(world_def(GetParam(), 0.05f));
  EmitterDef duct;
  duct.fluid = world.create_fluid({});
  duct.opening = RectangleOpening{0.2f, 0.2f};
  duct.mode = EmitterMode::imposed;
  duct.speed = 1;
  const EmitterId emitter = world.create_emitter(duct);
  std::set<ParticleId> passed;
  for (int k = 0; k < 20; ++k) {
    world.step(0.01f);
    for (const FlowEvent& event : world.flow_events()) {
      EXPECT_EQ(event.emitter, emitter);
      EXPECT_TRUE(passed.insert(event.particle).second);
    }
  }
  EXPECT_EQ(passed.size(), world.emitter_count(emitter).total);
  EXPECT_GT(passed.size(), 0u);
  EXPECT_LT(passed.size(), world.particle_count());
}

MENISCUS_ON_EACH_DEVICE(EventsTest);

}  // namespace
}  // namespace meniscus::tests
