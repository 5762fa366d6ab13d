// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies of a world in a batch move bit for bit as those of a world alone.
#include <gtest/gtest.h>

#include "tests/unit/sdk/world/batch/batch_archetypes.h"
#include "tests/unit/sdk/world/batch/batch_worlds.h"

namespace meniscus::tests {
namespace {

Pose at(Vec3 position) {
  Pose pose;
  pose.position = position;
  return pose;
}

class BatchBodiesTest : public BatchOnDevice {
 protected:
  World archetype(const WorldDef& def) const override { return pool(def).world; }
  Pool pool_of_kind(uint32_t kind) const {
    WorldDef own = def();
    own.gravity = gravity_of(kind);
    return pool(own);
  }
};

TEST_P(BatchBodiesTest, StatesAreThoseOfAWorldAlone) {
  WorldBatch made = batch(3);
  run_batch(made, 20);
  Pool own = pool_of_kind(1);
  run(own.world, 20, batch_dt);
  const std::span<const BodyState> all = made.body_states();
  ASSERT_EQ(made.body_count(), 4u);
  ASSERT_EQ(all.size(), 12u);
  for (const BodyId id : {own.box, own.ball, own.arm, own.paddle}) {
    const BodyState got = all[4 + id.index], expected = own.world.body_state(id);
    EXPECT_EQ(got.pose.position, expected.pose.position);
    EXPECT_EQ(got.velocity, expected.velocity);
    EXPECT_EQ(got.fluid_force, expected.fluid_force);
    EXPECT_EQ(got.awake, expected.awake);
  }
  EXPECT_GT(length(all[4].fluid_force), 1.0f) << "the box stands in water";
}

/// Manifolds, their warm starts, and what bodies have been used to are of that state.
TEST_P(BatchBodiesTest, StartsFromBodiesThatHaveSettled) {
  Pool own = pool(def());
  run(own.world, 60, batch_dt);
  WorldBatch made(own.world, {3});
  run_batch(made, 15);
  made.reset(mask_of(3, {1}));
  EXPECT_EQ(made.state_hashes()[1], own.world.state_hash());
  EXPECT_EQ(made.body_states()[4].fluid_force, own.world.body_state(own.box).fluid_force);
  run_batch(made, 15);
  run(own.world, 15, batch_dt);
  EXPECT_EQ(made.state_hashes()[1], own.world.state_hash());
  run(own.world, 15, batch_dt);
  EXPECT_EQ(made.state_hashes()[0], own.world.state_hash());
}

TEST_P(BatchBodiesTest, AnInsertedWorldGoesOn) {
  WorldBatch made = batch(3);
  run_batch(made, 5);
  Pool other = pool(def());
  other.world.set_body_pose(other.ball, at({0.3f, 0.8f, 0.2f}));
  other.world.set_body_velocity(other.box, {1, 0, 0}, {0, 2, 0});
  made.insert(1, other.world);
  EXPECT_EQ(made.status()[1].time, 0);
  run(other.world, 20, batch_dt);
  run_batch(made, 20);
  EXPECT_EQ(made.state_hashes()[1], other.world.state_hash());
  EXPECT_EQ(made.state_hashes()[2], alone(2, 25));
}

TEST_P(BatchBodiesTest, CallsActInOneWorld) {
  const Pool names = pool(def());
  WorldBatch made(names.world, {4});
  made.set_gravities(std::vector<Vec3>{gravity_of(0), gravity_of(1), gravity_of(2), gravity_of(3)});
  run_batch(made, 5);
  Pool own[4] = {pool_of_kind(0), pool_of_kind(1), pool_of_kind(2), pool_of_kind(3)};
  for (Pool& one : own) run(one.world, 5, batch_dt);
  const Pose in_water = at({0.2f, 0.3f, 0.25f}), target = at({0.5f, 0.5f, 0.25f});
  made.set_body_pose(0, names.ball, in_water);
  own[0].world.set_body_pose(own[0].ball, in_water);
  made.set_body_velocity(1, names.ball, {0, 3, 0}, {1, 0, 0});
  own[1].world.set_body_velocity(own[1].ball, {0, 3, 0}, {1, 0, 0});
  made.move_body(2, names.paddle, target, 0.3f);
  own[2].world.move_body(own[2].paddle, target, 0.3f);
  for (int k = 0; k < 20; ++k) {
    made.apply_force(3, names.box, {0, 80, 0});
    own[3].world.apply_force(own[3].box, {0, 80, 0});
    made.apply_torque(3, names.ball, {0, 0, 0.1f});
    own[3].world.apply_torque(own[3].ball, {0, 0, 0.1f});
    made.step(batch_dt);
    for (Pool& one : own) one.world.step(batch_dt);
  }
  for (uint32_t w = 0; w < 4; ++w) {
    EXPECT_EQ(made.state_hashes()[w], own[w].world.state_hash()) << "world " << w;
    EXPECT_NE(made.state_hashes()[w], alone(w, 25)) << "the call has no effect in world " << w;
  }
}

/// Ids are those of the archetype: their indices are the same.
TEST_P(BatchBodiesTest, ContactsAndEventsAreThoseOfAWorldAlone) {
  const Pool names = pool(def());
  WorldBatch made(names.world, {3});
  made.set_gravities(std::vector<Vec3>{gravity_of(0), gravity_of(1), gravity_of(2)});
  Pool own = pool_of_kind(1);
  size_t events = 0;
  for (int k = 0; k < 60; ++k) {
    made.step(batch_dt);
    own.world.step(batch_dt);
    const std::vector<ContactEvent> got = made.contact_events(1);
    const std::vector<ContactEvent> expected = own.world.contact_events();
    ASSERT_EQ(got.size(), expected.size()) << "step " << k;
    for (size_t n = 0; n < got.size(); ++n) {
      EXPECT_EQ(got[n].a.index, expected[n].a.index);
      EXPECT_EQ(got[n].b.index, expected[n].b.index);
      EXPECT_EQ(got[n].shape.index, expected[n].shape.index);
      EXPECT_EQ(got[n].began, expected[n].began);
    }
    events += got.size();
  }
  EXPECT_GT(events, 2u);
  const std::vector<SolidContact> got = made.solid_contacts(1), expected = own.world.solid_contacts();
  ASSERT_EQ(got.size(), expected.size());
  ASSERT_GT(got.size(), 0u);
  for (size_t n = 0; n < got.size(); ++n) {
    EXPECT_EQ(got[n].a.index, expected[n].a.index);
    EXPECT_EQ(got[n].point, expected[n].point);
    EXPECT_EQ(got[n].impulse, expected[n].impulse);
  }
  EXPECT_EQ(got[0].a, names.box) << "the ids are those of the archetype";
}

/// A box that rests on a shelf above a little water falls asleep, and is woken in one world.
TEST_P(BatchBodiesTest, SleepEventsAreThoseOfAWorldAlone) {
  World own(def());
  const FluidId water = own.create_fluid({});
  own.create_shape(tank({0, 0, 0}, {1, 1, 0.5f}));
  own.create_shape(shape(BoxGeometry{{0.2f, 0.05f, 0.2f}}, {0.7f, 0.6f, 0.25f}));
  const BodyId box =
      own.create_body(validation::body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0.7f, 0.75f, 0.25f}, 900));
  own.add_fluid(block(water, {0, 0, 0}, {0.3f, 0.1f, 0.3f}));
  WorldBatch made(own, {2});
  std::vector<SleepEvent> seen;
  const auto step = [&] {
    made.step(batch_dt);
    own.step(batch_dt);
    const std::vector<SleepEvent> got = made.sleep_events(1), expected = own.sleep_events();
    ASSERT_EQ(got.size(), expected.size());
    for (size_t n = 0; n < got.size(); ++n) {
      EXPECT_EQ(got[n].body, expected[n].body);
      EXPECT_EQ(got[n].awake, expected[n].awake);
    }
    seen.insert(seen.end(), got.begin(), got.end());
  };
  for (int k = 0; k < 400 && seen.empty(); ++k) step();
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].body, box);
  EXPECT_FALSE(seen[0].awake);
  EXPECT_EQ(made.sleep_events(0).size(), 1u) << "the other world has the same";
  step();
  EXPECT_EQ(seen.size(), 1u) << "it sleeps on";
  made.apply_impulse(1, box, {0, 50, 0}, {0.7f, 0.75f, 0.25f});
  own.apply_impulse(box, {0, 50, 0}, {0.7f, 0.75f, 0.25f});
  step();
  ASSERT_EQ(seen.size(), 2u) << "woken by a call";
  EXPECT_TRUE(seen[1].awake);
  EXPECT_TRUE(made.sleep_events(0).empty());
}

/// Points of contacts are in the user's frame, as in a world alone.
TEST_P(BatchBodiesTest, ContactsAreGivenAboutTheOrigin) {
  WorldDef far = def();
  far.origin = {1000, 0, -1000};
  World own(far);
  const FluidId water = own.create_fluid({});
  own.create_shape(tank({1000, 0, -1000}, {1001, 1, -999.5f}));
  own.create_body(validation::body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {1000.7f, 0.1f, -999.75f}, 900));
  own.add_fluid(block(water, {1000, 0, -1000}, {1000.3f, 0.1f, -999.7f}));
  WorldBatch made(own, {2});
  run_batch(made, 3);
  run(own, 3, batch_dt);
  const std::vector<SolidContact> got = made.solid_contacts(1), expected = own.solid_contacts();
  ASSERT_EQ(got.size(), expected.size());
  ASSERT_GT(got.size(), 0u);
  for (size_t n = 0; n < got.size(); ++n) EXPECT_EQ(got[n].point, expected[n].point);
  EXPECT_NEAR(got[0].point.x, 1000.7f, 0.2f);
}

TEST_P(BatchBodiesTest, AWorldThatGoesBackHasNoEvents) {
  const Pool names = pool(def());
  WorldBatch made(names.world, {2});
  const auto step_to_events = [&] {
    for (int k = 0; k < 60 && made.contact_events(1).empty(); ++k) made.step(batch_dt);
    EXPECT_FALSE(made.contact_events(1).empty());
  };
  step_to_events();
  made.reset(mask_of(2, {1}));
  EXPECT_TRUE(made.contact_events(1).empty());
  EXPECT_TRUE(made.solid_contacts(1).empty());
  step_to_events();
  made.apply_force(1, names.ball, {0, 3e38f, 0});
  EXPECT_EQ(made.step(batch_dt).failed, 1u);
  EXPECT_TRUE(made.contact_events(1).empty());
  EXPECT_THROW(made.contact_events(2), Error);
}

/// A body that is thrown out of the range of floats.
TEST_P(BatchBodiesTest, AWorldWithABodyThatFailsGoesBackAlone) {
  const Pool names = pool(def());
  WorldBatch made(names.world, {7});
  run_batch(made, 15);
  const uint64_t before = made.state_hashes()[4];
  made.apply_force(4, names.ball, {0, 3e38f, 0});
  EXPECT_EQ(made.step(batch_dt).failed, 1u);
  EXPECT_TRUE(made.status()[4].failed);
  EXPECT_EQ(made.state_hashes()[4], before);
  run_batch(made, 10);
  Pool own = pool(def());
  run(own.world, 26, batch_dt);
  for (uint32_t w = 0; w < 7; ++w)
    EXPECT_EQ(made.state_hashes()[w], w == 4 ? before : own.world.state_hash()) << "world " << w;
  made.reset(mask_of(7, {4}));
  run_batch(made, 26);
  EXPECT_EQ(made.state_hashes()[4], own.world.state_hash());
}

TEST_P(BatchBodiesTest, ThreadsDoNotChangeBits) {
  uint64_t hashes[2];
  for (int k = 0; k < 2; ++k) {
    WorldBatch made(pool(def()).world, {5, k == 0 ? 1 : 2});
    run_batch(made, 30);
    hashes[k] = made.state_hashes()[4];
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST_P(BatchBodiesTest, ChecksItsArguments) {
  const Pool names = pool(def());
  WorldBatch made(names.world, {2});
  const auto expect_refused = [&](const char* what, const auto& call) {
    EXPECT_NE(refusal_of(call).find(what), std::string::npos) << refusal_of(call);
  };
  expect_refused("apply_force's world", [&] { made.apply_force(2, names.box, {0, 1, 0}); });
  expect_refused("dynamic bodies alone", [&] { made.set_body_velocity(0, names.paddle, {}, {}); });
  expect_refused("kinematic bodies alone", [&] { made.move_body(0, names.box, {}, 1); });
  expect_refused("BatchDef::rigid_threads", [&] { WorldBatch(names.world, {2, -1}); });
  EXPECT_THROW(made.apply_torque(0, pool(def()).box, {0, 0, 1}), Error) << "an id of another world";
  Pool more = pool(def());
  more.world.create_body(validation::body(SphereGeometry{0.05f}, {0.5f, 0.9f, 0.25f}, 400));
  expect_refused("5 bodies", [&] { made.insert(0, more.world); });
  made.step(batch_dt);
  EXPECT_EQ(made.state_hashes()[0], made.state_hashes()[1]);
}

MENISCUS_ON_EACH_DEVICE(BatchBodiesTest);

}  // namespace
}  // namespace meniscus::tests
