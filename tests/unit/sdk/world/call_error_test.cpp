// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Calls that must fail, and leave the world as it was.
#include <gtest/gtest.h>

#include <limits>

#include "tests/expect_error.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr ErrorCode invalid = ErrorCode::invalid_argument;

class CallErrorTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), 0.05f)};
  FluidId water_ = world_.create_fluid({});

  void SetUp() override { world_.add_particles(water_, lattice(4, 4, 4, 0.05f, {0, 0, 0})); }

  template <class Call>
  void expect_refused(ErrorCode code, const std::string& named, const Call& call) {
    const uint64_t hash = world_.state_hash();
    expect_error(code, named, call);
    EXPECT_EQ(world_.state_hash(), hash);
    EXPECT_EQ(world_.particle_count(), 64u);
    world_.step(0.001f);  // and it still runs
  }
};

TEST_P(CallErrorTest, AddParticlesRefusesWhatIsNotFinite) {
  const std::vector<Vec3> good{{1, 1, 1}, {2, 2, 2}}, bad{{1, 1, 1}, {nan, 0, 0}};
  expect_refused(invalid, "position", [&] { world_.add_particles(water_, bad); });
  expect_refused(invalid, "velocity", [&] { world_.add_particles(water_, good, bad); });
}

TEST_P(CallErrorTest, AddParticlesWantsAVelocityForEach) {
  const std::vector<Vec3> two{{1, 1, 1}, {2, 2, 2}}, three(3, Vec3{0, 0, 0});
  expect_refused(invalid, "3 velocities", [&] { world_.add_particles(water_, two, three); });
}

TEST_P(CallErrorTest, AFluidMustBeThere) {
  const std::vector<Vec3> one{{1, 1, 1}};
  const FluidId unknown{7, 0}, stale{water_.index, 1};
  for (FluidId id : {unknown, stale, FluidId{}}) {
    expect_refused(ErrorCode::not_found, "fluid", [&] { world_.add_particles(id, one); });
    expect_refused(ErrorCode::not_found, "fluid", [&] { world_.add_fluid(block(id, {0, 0, 0}, {1, 1, 1})); });
    expect_refused(ErrorCode::not_found, "fluid", [&] { world_.particle_mass(id); });
  }
}

TEST_P(CallErrorTest, AddFluidChecksItsRegion) {
  FluidVolumeDef def = block(water_, {0, 0, 0}, {-1, 1, 1});
  expect_refused(invalid, "BoxRegion", [&] { world_.add_fluid(def); });
  def.region = BallRegion{-1};
  expect_refused(invalid, "radius", [&] { world_.add_fluid(def); });
  def.region = MeshRegion{"x.obj", -1};
  expect_refused(invalid, "scale", [&] { world_.add_fluid(def); });
  def.region = BoxRegion{};
  def.velocity = {nan, 0, 0};
  expect_refused(invalid, "velocity", [&] { world_.add_fluid(def); });
  def.velocity = {0, 0, 0};
  def.pose.rotation = {0, 0, 0, 0};
  expect_refused(invalid, "pose", [&] { world_.add_fluid(def); });
}

TEST_P(CallErrorTest, MoreParticlesThanAWorldHoldsAreRefused) {
  expect_refused(ErrorCode::capacity, "particles", [&] {
    world_.add_fluid(block(water_, {-100, -100, -100}, {100, 100, 100}));
  });
  FluidVolumeDef ball;
  ball.fluid = water_;
  ball.region = BallRegion{1e6f};
  expect_refused(ErrorCode::capacity, "particles", [&] { world_.add_fluid(ball); });
}

TEST_P(CallErrorTest, RemoveParticlesRefusesUnknownIds) {
  const std::vector<ParticleId> some_wrong{0, 3, 64}, all_wrong{1000000};
  expect_refused(ErrorCode::not_found, "64", [&] { world_.remove_particles(some_wrong); });
  expect_refused(ErrorCode::not_found, "1000000", [&] { world_.remove_particles(all_wrong); });
}

TEST_P(CallErrorTest, AStepTakesAPositiveTime) {
  for (float dt : {0.0f, -0.01f, nan, std::numeric_limits<float>::infinity()}) {
    expect_refused(invalid, "dt", [&] { world_.step(dt); });
  }
  // Half of the smallest float is none.
  expect_refused(invalid, "at least 1e-12", [&] { world_.step(std::numeric_limits<float>::denorm_min()); });
  world_.step(1e-12f);
}

TEST_P(CallErrorTest, RelaxTakesNoNegativeNumber) {
  expect_refused(invalid, "iterations", [&] { world_.relax(-1); });
}

TEST_P(CallErrorTest, WhatIsDestroyedCannotBeUsed) {
  const ShapeId shape_id = world_.create_shape(shape(PlaneGeometry{{0, 1, 0}, -10}));
  const SinkId sink = world_.create_sink({"", BoxRegion{{8, 8, 8}, {9, 9, 9}}, false, {}, {}});
  const ProbeId probe = world_.create_probe({});
  world_.destroy_shape(shape_id);
  world_.destroy_sink(sink);
  world_.destroy_probe(probe);
  expect_refused(ErrorCode::not_found, "shape", [&] { world_.destroy_shape(shape_id); });
  expect_refused(ErrorCode::not_found, "sink", [&] { world_.destroy_sink(sink); });
  expect_refused(ErrorCode::not_found, "probe", [&] { world_.destroy_probe(probe); });
  expect_refused(ErrorCode::not_found, "probe", [&] { world_.probe(probe); });
  // Their places are taken again, and the old ids still mean nothing.
  const ShapeId next = world_.create_shape(shape(PlaneGeometry{{0, 1, 0}, -10}));
  EXPECT_FALSE(next == shape_id);
  expect_refused(ErrorCode::not_found, "shape", [&] { world_.destroy_shape(shape_id); });
  world_.destroy_shape(next);
}

TEST_P(CallErrorTest, IdsThatNoCreateCallGaveAreRefused) {
  expect_refused(ErrorCode::not_found, "shape", [&] { world_.destroy_shape({}); });
  expect_refused(ErrorCode::not_found, "shape", [&] { world_.destroy_shape({0, 0}); });
  expect_refused(ErrorCode::not_found, "probe", [&] { world_.probe({3, 1}); });
}

TEST_P(CallErrorTest, IdsOfAnotherWorldAreRefused) {
  World other(world_def(GetParam(), 0.05f));
  const ShapeId foreign = other.create_shape(shape(PlaneGeometry{{0, 1, 0}, -10}));
  world_.create_shape(shape(PlaneGeometry{{0, 1, 0}, -10}));
  expect_refused(ErrorCode::not_found, "shape", [&] { world_.destroy_shape(foreign); });
}

MENISCUS_ON_EACH_DEVICE(CallErrorTest);

TEST(DeviceChoiceTest, CudaIsRefusedWithTheReasonWhereItCannotBeUsed) {
  if (usable_devices().size() == 2) {
    EXPECT_EQ(World(world_def(pbd::DeviceKind::cuda, 0.05f)).device().kind, "cuda");
    return;
  }
  expect_error(ErrorCode::device, pbd::cuda_status().reason,
               [] { World world(world_def(pbd::DeviceKind::cuda, 0.05f)); });
  const World fallback{WorldDef{}};
  EXPECT_EQ(fallback.device().kind, "cpu");
  EXPECT_NE(fallback.device().reason.find(pbd::cuda_status().reason), std::string::npos);
}

}  // namespace
}  // namespace meniscus::tests
