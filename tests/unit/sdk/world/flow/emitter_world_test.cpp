// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Emitters as part of a world: ids, bits, failures, memory, bodies that carry them.
#include <gtest/gtest.h>

#include "tests/many_threads.h"
#include "tests/unit/sdk/world/flow/emitter_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = emitter_spacing;

/// A jet that rises, falls into a basin, and leaves over its rim: emitters, sinks, bodies and cloth at once.
struct Fountain {
  World world;
  FluidId water = world.create_fluid({});
  EmitterId emitter;
  SinkId drain;

  explicit Fountain(const WorldDef& def) : world(def) {
    world.create_shape(shape(PlaneGeometry{}));
    EmitterDef jet = tests::emitter(water, DiscOpening{1.7f * s}, 3);
    jet.pose = {{0, 0.1f, 0}, about_z(10)};
    emitter = world.create_emitter(jet);
    SinkDef low;
    low.region = BallRegion{0.45f};
    low.outside = true;
    drain = world.create_sink(low);
    world.create_body(body(BoxGeometry{{0.06f, 0.06f, 0.06f}}, {-0.2f, 0.1f, 0}));
    ClothDef cloth;
    cloth.geometry = SheetGeometry{0.2f, 0.2f, 5, 5};
    cloth.pose.position = {0.3f, 0.2f, 0};
    world.create_cloth(cloth);
  }
};

class EmitterWorldTest : public OnDevice {
 protected:
  WorldDef def_ = world_def(GetParam(), s);
};

TEST_P(EmitterWorldTest, IdsGoOnAndStayInOrder) {
  Fountain f(def_);
  run(f.world, 80, 1.0f / 60);
  const std::span<const ParticleId> ids = f.world.ids();
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  const FlowCount made = f.world.emitter_count(f.emitter), gone = f.world.sink_count(f.drain);
  EXPECT_GT(gone.total, 50u);
  EXPECT_EQ(made.total - gone.total, ids.size());
  EXPECT_LT(ids.back(), made.total);
  EXPECT_EQ(f.world.positions().size(), ids.size());
  EXPECT_EQ(f.world.velocities().size(), ids.size());
  // The newest is the last, and nearest to the opening.
  EXPECT_LT(length(f.world.positions().back() - Vec3{0, 0.1f, 0}), 0.1f);
}

TEST_P(EmitterWorldTest, AParticleKeepsItsIdWhileOthersComeAndGo) {
  def_.gravity = {0, 0, 0};
  World world(def_);
  const FluidId water = world.create_fluid({});
  EmitterDef slow = emitter(water, DiscOpening{0.4f * s}, 1);
  world.create_emitter(slow);
  world.create_sink({"", HalfSpaceRegion{{0, -1, 0}, -0.6f}, false, {}, {}});  // y > 0.6
  const std::vector<Vec3> mine{{0.5f, 0, 0}}, drift{{0, 0.3f, 0}};
  run(world, 20, 0.05f);
  const ParticleId id = world.add_particles(water, mine, drift);
  for (int k = 1; k <= 20; ++k) {
    world.step(0.05f);
    const auto at = std::lower_bound(world.ids().begin(), world.ids().end(), id);
    ASSERT_EQ(*at, id);
    const Vec3 p = world.positions()[static_cast<size_t>(at - world.ids().begin())];
    EXPECT_LT(length(p - (mine[0] + 0.05f * static_cast<float>(k) * drift[0])), 1e-3f);
  }
}

TEST_P(EmitterWorldTest, TwoRunsAreAlike) {
  Fountain a(def_), b(def_);
  run(a.world, 50, 1.0f / 60);
  run(b.world, 50, 1.0f / 60);
  EXPECT_EQ(a.world.state_hash(), b.world.state_hash());
}

TEST_P(EmitterWorldTest, AStepThatFailsMakesNothingAndLeavesNoTrace) {
  Fountain a(def_), b(def_);
  run(a.world, 20, 1.0f / 60);
  run(b.world, 20, 1.0f / 60);
  const size_t count = a.world.particle_count();
  const FlowCount before = a.world.emitter_count(a.emitter);
  const std::vector<Vec3> there{{0, 5, 0}}, mad{{3e38f, 3e38f, 3e38f}};
  const std::vector<ParticleId> culprit{a.world.add_particles(a.water, there, mad)};
  b.world.remove_particles(std::vector<ParticleId>{b.world.add_particles(b.water, there)});
  expect_error(ErrorCode::non_finite, "non-finite", [&] { a.world.step(2); });
  EXPECT_EQ(a.world.particle_count(), count + 1);
  EXPECT_EQ(a.world.emitter_count(a.emitter).total, before.total);
  a.world.remove_particles(culprit);
  run(a.world, 20, 1.0f / 60);
  run(b.world, 20, 1.0f / 60);
  EXPECT_EQ(a.world.state_hash(), b.world.state_hash());
}

TEST_P(EmitterWorldTest, MoreThanAWorldHoldsIsRefusedBeforeAnythingHappens) {
  Fountain f(def_);
  run(f.world, 5, 1.0f / 60);
  EmitterDef hose = emitter(f.water, DiscOpening{1}, 1e9f);
  hose.name = "hose";
  f.world.create_emitter(hose);
  const uint64_t hash = f.world.state_hash();
  const double time = f.world.time();
  expect_error(ErrorCode::capacity, "the emitter \"hose\"", [&] { f.world.step(1.0f / 60); });
  EXPECT_EQ(f.world.state_hash(), hash);
  EXPECT_EQ(f.world.time(), time);
}

// What a sprinkler throws has its arm's velocity on top.
TEST_P(EmitterWorldTest, ABodyCarriesItsEmitter) {
  def_.gravity = {0, 0, 0};
  World world(def_);
  const FluidId water = world.create_fluid({});
  BodyDef cart = kinematic(BoxGeometry{{0.05f, 0.05f, 0.05f}});
  cart.keyframes = {{0, {}}, {10, {{20, 0, 0}, {0, 0, 0, 1}}}};  // 2 m/s along x
  const BodyId carrier = world.create_body(cart);
  EmitterDef def = emitter(water, DiscOpening{0.4f * s}, 1);
  def.body = carrier;
  def.pose.position = {0, 0.1f, 0};
  world.create_emitter(def);
  run(world, 60, 1.0f / 60);
  ASSERT_GT(world.particle_count(), 5u);
  for (size_t i = 0; i < world.particle_count(); ++i) {
    EXPECT_LT(length(world.velocities()[i] - Vec3{2, 1, 0}), 2e-3f);
    EXPECT_NEAR(world.positions()[i].x, 2 * world.time(), 2e-3);  // still above the opening
  }
}

TEST_P(EmitterWorldTest, ABodyThatTurnsThrowsInAllDirections) {
  def_.gravity = {0, 0, 0};
  World world(def_);
  BodyDef top = body(SphereGeometry{0.05f});
  top.angular_velocity = {0, 0, 2 * pi};
  const BodyId rotor = world.create_body(top);
  EmitterDef def = emitter(world.create_fluid({}), DiscOpening{0.4f * s}, 1);
  def.body = rotor;
  def.pose.position = {0, 0.1f, 0};
  world.create_emitter(def);
  world.step(0.02f);
  run(world, 49, 0.02f);
  ASSERT_GT(world.particle_count(), 8u);
  // A particle has left at 0.125 m from the axis, when the arm stood at an angle that its velocity tells:
  // 1 m/s along the arm and ωr across it.
  for (size_t i = 0; i < world.particle_count(); ++i) {
    const Vec3 v = world.velocities()[i];
    const float radius = 0.1f + 0.5f * std::max(s, s * s * s / (pi * 0.16f * s * s));
    EXPECT_NEAR(length(v), std::hypot(1.0f, 2 * pi * radius), 0.02f);
    EXPECT_NEAR(dot(world.positions()[i], v) / length(v),
                std::sqrt(std::max(0.0f, dot(world.positions()[i], world.positions()[i]) -
                                             std::pow(radius * 2 * pi * radius / length(v), 2.0f))),
                0.02f);
  }
}

TEST_P(EmitterWorldTest, WhatABodyCarriesGoesWithIt) {
  World world(def_);
  const BodyId carrier = world.create_body(body(SphereGeometry{0.1f}));
  EmitterDef def = emitter(world.create_fluid({}), DiscOpening{s}, 1);
  def.body = carrier;
  const EmitterId jet = world.create_emitter(def);
  SinkDef sink;
  sink.body = carrier;
  const SinkId drain = world.create_sink(sink);
  world.destroy_body(carrier);
  expect_error(ErrorCode::not_found, "emitter", [&] { world.emitter_count(jet); });
  expect_error(ErrorCode::not_found, "sink", [&] { world.sink_count(drain); });
  EXPECT_EQ(world.step(0.1f).emitted, 0u);
}

TEST_P(EmitterWorldTest, AFountainRunsForEverInTheSameMemory) {
  WorldDef def = world_def(GetParam(), 0.1f);
  def.substeps = 2;
  def.iterations = 4;
  World world(def);
  const FluidId water = world.create_fluid({});
  world.create_shape(shape(PlaneGeometry{}));
  EmitterDef jet = emitter(water, RectangleOpening{0.3f, 0.3f}, 3);
  jet.pose.position.y = 0.05f;
  const EmitterId id = world.create_emitter(jet);
  const SinkId drain = world.create_sink({"", BallRegion{1.2f}, true, {}, {}});
  run(world, 300, 1.0f / 60);
  const size_t held = world.device_bytes(), settled = world.particle_count();
  size_t least = settled, most = settled;
  for (int k = 0; k < 700; ++k) {
    world.step(1.0f / 60);
    least = std::min(least, world.particle_count());
    most = std::max(most, world.particle_count());
  }
  EXPECT_GT(world.emitter_count(id).total, 2000u);
  EXPECT_EQ(world.emitter_count(id).total - world.sink_count(drain).total, world.particle_count());
  EXPECT_LT(double(most - least), 0.25 * double(settled));
  EXPECT_EQ(world.device_bytes(), held);
}

TEST_P(EmitterWorldTest, Mistakes) {
  constexpr ErrorCode invalid = ErrorCode::invalid_argument;
  World world(def_);
  const EmitterDef good = emitter(world.create_fluid({}), DiscOpening{s}, 1);
  const auto refused = [&](ErrorCode code, const std::string& named, const auto& spoil) {
    EmitterDef def = good;
    spoil(def);
    expect_error(code, named, [&] { world.create_emitter(def); });
  };
  refused(ErrorCode::not_found, "fluid", [](EmitterDef& d) { d.fluid = {}; });
  refused(ErrorCode::not_found, "body", [](EmitterDef& d) { d.body = BodyId{}; });
  for (float bad : {0.0f, -1.0f, not_a_number, infinity}) {
    refused(invalid, "speed", [&](EmitterDef& d) { d.speed = bad; });
    refused(invalid, "radius", [&](EmitterDef& d) { d.opening = DiscOpening{bad}; });
    refused(invalid, "width", [&](EmitterDef& d) { d.opening = RectangleOpening{bad, 1}; });
    refused(invalid, "depth", [&](EmitterDef& d) { d.opening = RectangleOpening{1, bad}; });
  }
  refused(invalid, "rate", [](EmitterDef& d) { d.rate = -1; });
  refused(invalid, "0.00785", [](EmitterDef& d) { d.rate = 0.01f; });  // more than the speed carries
  refused(invalid, "start", [](EmitterDef& d) { d.start = -1; });
  refused(invalid, "stop", [](EmitterDef& d) { d.stop = not_a_number; });
  refused(invalid, "stop", [](EmitterDef& d) { d.start = 2, d.stop = 1; });
  refused(invalid, "pose", [](EmitterDef& d) { d.pose.position.x = infinity; });
  refused(invalid, "million", [](EmitterDef& d) { d.opening = DiscOpening{1e4f}; });
  refused(invalid, "million", [](EmitterDef& d) { d.opening = RectangleOpening{1e-6f, 1e6f}; });
  refused(ErrorCode::io, "/no/such.obj", [](EmitterDef& d) { d.opening = MeshOpening{"/no/such.obj", 1}; });
  EXPECT_EQ(world.step(0.01f).emitted, 0u);
}

MENISCUS_ON_EACH_DEVICE(EmitterWorldTest);

TEST(CpuEmitters, TheNumberOfThreadsLeavesNoTrace) {
  const ManyThreads allowed;
  WorldDef def = world_def(pbd::DeviceKind::cpu, s);
  std::optional<uint64_t> one;
  for (int threads : {1, 2, 5}) {
    def.threads = threads;
    Fountain f(def);
    run(f.world, 50, 1.0f / 60);
    if (!one) one = f.world.state_hash();
    EXPECT_EQ(f.world.state_hash(), *one) << threads << " threads";
  }
}

}  // namespace
}  // namespace meniscus::tests
