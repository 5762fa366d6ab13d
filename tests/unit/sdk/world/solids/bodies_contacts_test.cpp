// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Which bodies touch each other, and with what impulse.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/rigid_solvers.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 0.01f;

class BodyContactsTest : public WithSolver {
 protected:
  World world_{world_def(GetParam(), 0.05f)};

  static BodyDef cube(Vec3 position) { return body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, position); }

  /// The events of all steps up to a time.
  std::vector<ContactEvent> events_during(int steps) {
    std::vector<ContactEvent> all;
    for (int k = 0; k < steps; ++k) {
      world_.step(dt);
      all.insert(all.end(), world_.contact_events().begin(), world_.contact_events().end());
    }
    return all;
  }

  /// Water with a cube that is sinking in it.
  BodyId add_cube_in_water(World& world) const {
    world.create_shape(open_tank({0.25f, 0.5f, 0.25f}));
    world.add_fluid(block(world.create_fluid({}), {-0.25f, 0, -0.25f}, {0.25f, 0.3f, 0.25f}));
    BodyDef def = cube({0.02f, 0.4f, 0});
    def.velocity = {0, -1, 0};
    return world.create_body(def);
  }
  /// One substep a step: what is said of the last substep is true of the step.
  World single() const {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.substeps = 1;
    return World(def);
  }
};

void expect_same(const std::vector<ParticleContact>& found, const std::vector<ParticleContact>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].particle, expected[k].particle);
    EXPECT_EQ(found[k].impulse, expected[k].impulse);
  }
}

TEST_P(BodyContactsTest, EventsTellWhenATouchBeginsAndWhenItEnds) {
  const ShapeId floor = world_.create_shape(shape(PlaneGeometry{}));
  const BodyId id = world_.create_body(cube({0, 0.15f, 0}));
  EXPECT_TRUE(world_.contact_events().empty());
  std::vector<ContactEvent> events = events_during(50);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_TRUE(events[0].began);
  EXPECT_EQ(events[0].a, id);
  EXPECT_EQ(events[0].shape, floor);
  EXPECT_EQ(events[0].b, BodyId{});
  world_.set_body_velocity(id, {0, 3, 0}, {0, 0, 0});
  events = events_during(20);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_FALSE(events[0].began);
  EXPECT_EQ(events[0].a, id);
  EXPECT_EQ(events[0].shape, floor);
}

TEST_P(BodyContactsTest, TwoBodiesThatTouchAreOneEvent) {
  world_ = World(weightless(GetParam()));
  const BodyId a = world_.create_body(cube({0, 0, 0}));
  BodyDef def = cube({0.5f, 0, 0});
  def.velocity = {-2, 0, 0};
  const BodyId b = world_.create_body(def);
  const std::vector<ContactEvent> events = events_during(30);
  ASSERT_GE(events.size(), 1u);
  EXPECT_TRUE(events[0].began);
  EXPECT_TRUE((events[0].a == a && events[0].b == b) || (events[0].a == b && events[0].b == a));
  EXPECT_EQ(events[0].shape, ShapeId{});
}

// A touch with what is destroyed does not end later on in the name of what takes its place.
TEST_P(BodyContactsTest, WhatIsDestroyedHasNoEventsAnyMore) {
  const ShapeId first = world_.create_shape(shape(PlaneGeometry{}));
  const BodyId id = world_.create_body(cube({0, 0.1f, 0}));
  run(world_, 10, dt);
  world_.destroy_shape(first);
  const ShapeId second = world_.create_shape(shape(PlaneGeometry{{0, 1, 0}, -5}));
  ASSERT_EQ(second.index, first.index);
  EXPECT_TRUE(events_during(3).empty());
  world_.destroy_shape(second);
  const ShapeId third = world_.create_shape(shape(PlaneGeometry{{0, 1, 0}, -0.2f}));
  const std::vector<ContactEvent> events = events_during(30);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].shape, third);
  world_.destroy_body(id);
  const BodyId next = world_.create_body(cube({0, 8, 0}));
  ASSERT_EQ(next.index, id.index);
  EXPECT_TRUE(events_during(3).empty());
}

TEST_P(BodyContactsTest, SolidContactsCarryTheWeight) {
  const ShapeId floor = world_.create_shape(shape(PlaneGeometry{}));
  BodyDef def = cube({0, 0.1f, 0});
  def.can_sleep = false;
  const BodyId below = world_.create_body(def);
  def.pose.position.y = 0.3f;
  const BodyId above = world_.create_body(def);
  run(world_, 100, dt);
  const float weight = world_.body_mass(below).mass * 9.81f;
  float on_floor = 0, between = 0;
  for (const SolidContact& c : world_.solid_contacts()) {
    EXPECT_NEAR(c.distance, 0, 2e-3f);
    if (c.shape == floor) {
      EXPECT_EQ(c.a, below);
      EXPECT_NEAR(c.point.y, 0, 2e-3f);
      expect_near(c.normal, {0, 1, 0}, 1e-3f);
      on_floor += c.impulse;
    } else {
      EXPECT_TRUE((c.a == below && c.b == above) || (c.a == above && c.b == below));
      EXPECT_EQ(c.shape, ShapeId{});
      EXPECT_NEAR(c.point.y, 0.2f, 5e-3f);
      EXPECT_NEAR(c.normal.y, c.a == above ? 1 : -1, 1e-3f);
      between += c.impulse;
    }
  }
  const float substep = dt / 4;
  EXPECT_NEAR(on_floor, 2 * weight * substep, 0.02f * weight * substep);
  EXPECT_NEAR(between, weight * substep, 0.02f * weight * substep);
}

TEST_P(BodyContactsTest, NoBodyNoSolidContacts) {
  world_.create_shape(shape(PlaneGeometry{}));
  world_.create_shape(shape(BoxGeometry{}));
  world_.step(dt);
  EXPECT_TRUE(world_.solid_contacts().empty());
  EXPECT_TRUE(world_.contact_events().empty());
}

TEST_P(BodyContactsTest, ParticleContactsSumUpToTheFluidsForce) {
  World world = single();
  const BodyId id = add_cube_in_water(world);
  bool wet = false;
  for (int k = 0; k < 60; ++k) {
    world.step(0.005f);
    Vec3 sum{0, 0, 0}, torque{0, 0, 0};
    float size = 0;
    const BodyState state = world.body_state(id);
    for (const ParticleContact& c : world.particle_contacts()) {
      if (!(c.body == id)) continue;
      EXPECT_EQ(c.shape, ShapeId{});
      EXPECT_NEAR(length(c.normal), 1, 1e-4f);
      sum += c.impulse;
      torque += cross(c.point - state.centre_of_mass, c.impulse);
      size += length(c.impulse);
    }
    expect_near(-1 / 0.005f * sum, state.fluid_force, 1e-3f * (size / 0.005f) + 1e-5f);
    wet |= length(state.fluid_force) > 5;
  }
  EXPECT_TRUE(wet);
}

TEST_P(BodyContactsTest, ParticleContactsNameParticlesThatAreThere) {
  World world = single();
  const BodyId id = add_cube_in_water(world);
  run(world, 60, 0.005f);
  const std::vector<ParticleContact> contacts = world.particle_contacts();
  ASSERT_FALSE(contacts.empty());
  std::map<ParticleId, Vec3> places;
  for (size_t i = 0; i < world.particle_count(); ++i) places[world.ids()[i]] = world.positions()[i];
  size_t on_body = 0, on_tank = 0;
  for (const ParticleContact& c : contacts) {
    ASSERT_TRUE(places.contains(c.particle));
    EXPECT_LT(std::fabs(dot(c.normal, places[c.particle] - c.point)), 0.1f);
    EXPECT_LT(length(places[c.particle] - c.point), 0.15f);
    on_body += c.body == id;
    on_tank += c.shape.index == 0 && c.body == BodyId{};
  }
  EXPECT_GT(on_body, 20u);
  EXPECT_EQ(on_body + on_tank, contacts.size());
}

// They are as of the last step, whatever was looked at in between, and name the same particles when others
// are gone.
TEST_P(BodyContactsTest, LookingAtTheWorldDoesNotChangeItsContacts) {
  World world = single();
  add_cube_in_water(world);
  run(world, 60, 0.005f);
  World twin = single();
  add_cube_in_water(twin);
  run(twin, 60, 0.005f);
  const std::vector<ParticleContact> expected = twin.particle_contacts();
  ASSERT_FALSE(expected.empty());
  world.diagnostics();
  const std::vector<ParticleContact> found = world.particle_contacts();
  expect_same(found, expected);
}

TEST_P(BodyContactsTest, ContactsOfParticlesThatStayKeepTheirNames) {
  World world = single();
  add_cube_in_water(world);
  run(world, 60, 0.005f);
  World twin = single();
  add_cube_in_water(twin);
  run(twin, 60, 0.005f);
  const std::vector<ParticleContact> before = twin.particle_contacts();
  std::vector<ParticleId> first_half(world.ids().begin(), world.ids().begin() + world.particle_count() / 2);
  world.remove_particles(first_half);
  std::vector<ParticleContact> expected;
  std::copy_if(before.begin(), before.end(), std::back_inserter(expected),
               [&](const ParticleContact& c) { return c.particle > first_half.back(); });
  ASSERT_FALSE(expected.empty());
  const std::vector<ParticleContact> found = world.particle_contacts();
  expect_same(found, expected);
}

TEST_P(BodyContactsTest, ContactsOfParticlesThatASinkLeavesKeepTheirNames) {
  World world = single();
  add_cube_in_water(world);
  run(world, 60, 0.005f);
  world.create_sink({"", BoxRegion{{-1, -1, -1}, {0, 1, 1}}, false, {}, {}});
  ASSERT_GT(world.step(0.005f).removed, 100u);
  const std::vector<ParticleContact> contacts = world.particle_contacts();
  ASSERT_FALSE(contacts.empty());
  std::map<ParticleId, Vec3> places;
  for (size_t i = 0; i < world.particle_count(); ++i) places[world.ids()[i]] = world.positions()[i];
  for (const ParticleContact& c : contacts) {
    ASSERT_TRUE(places.contains(c.particle));
    ASSERT_LT(length(places[c.particle] - c.point), 0.15f);
  }
}

// As SolidContact and ContactEvent: an id of something that is gone stays the id of that.
TEST_P(BodyContactsTest, ContactsDoNotPassToWhatTakesAPlace) {
  World world = single();
  const BodyId gone = add_cube_in_water(world);
  run(world, 60, 0.005f);
  world.destroy_body(gone);
  const BodyId next = world.create_body(cube({3, 0, 0}));
  ASSERT_EQ(next.index, gone.index);
  for (const ParticleContact& c : world.particle_contacts()) ASSERT_FALSE(c.body == next);
}

MENISCUS_WITH_EACH_RIGID_SOLVER(BodyContactsTest);

}  // namespace
}  // namespace meniscus::tests
