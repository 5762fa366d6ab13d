// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Probes of level, flow, vectors and sums, on flows for which they are known.
#include <gtest/gtest.h>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;
constexpr float pi = 3.14159265f;

class GaugesTest : public OnDevice {
 protected:
  static WorldDef weightless() {
    WorldDef def = world_def(GetParam(), s);
    def.gravity = {0, 0, 0};
    return def;
  }

  static ProbeId create(World& world, ProbeKind kind, Vec3 point, Vec3 normal = {0, 1, 0},
                        float radius = 0.1f) {
    ProbeDef def;
    def.kind = kind;
    def.point = point;
    def.normal = normal;
    def.radius = radius;
    return world.create_probe(def);
  }
};

TEST_P(GaugesTest, TheLevelOfAPoolIgnoresSpray) {
  World world(world_def(GetParam(), s));
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {0.5f, 4, 0.5f}));
  world.add_fluid(block(water, {0, 0, 0}, {0.5f, 0.6f, 0.5f}));
  const ProbeId on_floor = create(world, ProbeKind::level, {0.25f, 0, 0.25f}, {0, 2, 0}, 0.2f),
                within = create(world, ProbeKind::level, {0.25f, 0.2f, 0.25f}, {0, 1, 0}, 0.2f);
  run(world, 60, 0.01f);
  EXPECT_NEAR(world.probe(on_floor), 0.6, 0.5 * s);
  EXPECT_NEAR(world.probe(within), 0.4, 0.5 * s);
  std::vector<Vec3> spray;
  for (int k = 0; k < 8; ++k) spray.push_back({0.2f + 0.01f * float(k), 2.5f + 0.1f * float(k), 0.25f});
  world.add_particles(water, spray);
  world.step(0.01f);
  EXPECT_NEAR(world.probe(on_floor), 0.6, 0.5 * s);
}

TEST_P(GaugesTest, ABlockThatMovesHasItsSumsAndItsFlow) {
  World world(weightless());
  FluidDef def;
  def.rest_density = 800;
  const FluidId water = world.create_fluid({}), oil = world.create_fluid(def);
  FluidVolumeDef volume = block(oil, {0, 0, 0}, {0.6f, 0.6f, 0.6f});
  volume.velocity = {1, 0, 0};
  world.add_fluid(volume);
  volume = block(water, {5, 0, 0}, {5.2f, 0.2f, 0.2f});
  world.add_fluid(volume);
  ProbeDef sum;
  sum.kind = ProbeKind::fluid_momentum;
  sum.fluid = oil;
  const ProbeId momentum = world.create_probe(sum);
  sum.kind = ProbeKind::fluid_centre;
  const ProbeId centre = world.create_probe(sum);
  sum.kind = ProbeKind::fluid_angular_momentum;
  sum.point = {0.3f, 1.3f, 0.3f};
  const ProbeId spin = world.create_probe(sum);
  sum.kind = ProbeKind::fluid_centre;
  sum.fluid.reset();
  const ProbeId both = world.create_probe(sum);
  const ProbeId flow = create(world, ProbeKind::flow, {0.35f, 0.3f, 0.3f}, {-2, 0, 0}, 0.2f);
  const ProbeId velocity = create(world, ProbeKind::point_velocity, {0.3f, 0.3f, 0.3f});
  const ProbeId density = create(world, ProbeKind::point_density, {0.3f, 0.3f, 0.3f});
  world.step(0.01f);
  const float mass = 800 * 0.6f * 0.6f * 0.6f, other = 1000 * 0.2f * 0.2f * 0.2f;
  EXPECT_NEAR(world.probe_vector(momentum).x / mass, 1, 1e-3);
  EXPECT_NEAR(world.probe(momentum) / mass, 1, 1e-3);
  EXPECT_NEAR(world.probe_vector(spin).z / mass, 1, 1e-2);
  EXPECT_NEAR(world.probe_vector(centre).x, 0.306f, 0.005f);  // on average over the step
  EXPECT_NEAR(world.probe_vector(both).x, (0.306f * mass + 5.1f * other) / (mass + other), 0.01f);
  EXPECT_NEAR(world.probe(flow) / (-pi * 0.2f * 0.2f), 1, 0.1);
  EXPECT_NEAR(world.probe_vector(velocity).x, 1, 0.01f);
  EXPECT_NEAR(world.probe(density) / 800, 1, 0.03);  // between the points of a lattice
  EXPECT_EQ(world.probe_vector(flow), (Vec3{0, 0, 0}));
}

TEST_P(GaugesTest, ForceAndTorqueOnAFloorAreThoseOfTheWeight) {
  World world(world_def(GetParam(), s));
  const FluidId water = world.create_fluid({});
  const ShapeId floor = world.create_shape(shape(PlaneGeometry{}));
  world.create_shape(tank({0, -1, 0}, {0.4f, 2, 0.4f}));
  world.add_fluid(block(water, {0, 0, 0}, {0.4f, 0.4f, 0.4f}));
  ProbeDef def;
  def.kind = ProbeKind::wall_force;
  def.shape = floor;
  const ProbeId force = world.create_probe(def);
  def.kind = ProbeKind::wall_torque;
  def.point = {-0.8f, 0, 0.2f};
  const ProbeId torque = world.create_probe(def);
  run(world, 100, 0.01f);
  double f = 0, t = 0;
  for (int k = 0; k < 50; ++k) {
    world.step(0.01f);
    f += double{world.probe_vector(force).y} / 50;
    t += double{world.probe_vector(torque).z} / 50;
  }
  const double weight = 9.81 * 1000 * 0.4 * 0.4 * 0.4;
  EXPECT_NEAR(f / -weight, 1, 0.02);
  EXPECT_NEAR(t / -weight, 1, 0.03);  // 1 m from the middle of the floor
}

TEST_P(GaugesTest, AProbeNeedsWhatItsKindNeeds) {
  World world(weightless());
  ProbeDef def;
  def.kind = ProbeKind::level;
  EXPECT_THROW(world.create_probe(def), Error);  // no radius
  def.radius = 0.1f;
  def.normal = {0, 0, 0};
  EXPECT_THROW(world.create_probe(def), Error);
  def.normal = {0, 1, 0};
  const ProbeId level = world.create_probe(def);
  world.step(0.01f);
  EXPECT_EQ(world.probe(level), 0);
}

MENISCUS_ON_EACH_DEVICE(GaugesTest);

}  // namespace
}  // namespace meniscus::tests
