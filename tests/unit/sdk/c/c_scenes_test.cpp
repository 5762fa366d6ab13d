// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Scenes that are built in C have the bits of the same scenes in C++, step by step, and the same read-outs.
#include <gtest/gtest.h>

#include <memory>

#include "tests/unit/sdk/c/c_scenes.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

struct Destroy {
  void operator()(MeniscusWorld* world) const { meniscus_world_destroy(world); }
};
using CWorld = std::unique_ptr<MeniscusWorld, Destroy>;

constexpr float dt = 0.02f;

class CScenes : public OnDevice {
 protected:
  const char* device() const { return GetParam() == pbd::DeviceKind::cuda ? "cuda" : "cpu"; }

  World empty_world() const {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.threads = 2;
    def.density.warm_start = 0.25f;
    return World(def);
  }

  static FluidId viscous_water(World& world) {
    FluidDef def;
    def.dynamic_viscosity = 0.5f;
    return world.create_fluid(def);
  }

  /// Steps both, and compares after each step.
  static void expect_equal(MeniscusWorld* in_c, World& world, int steps) {
    for (int k = 0; k < steps; ++k) {
      MeniscusStepReport report{};
      report.size = sizeof report;
      ASSERT_EQ(meniscus_step(in_c, dt, &report), MENISCUS_OK) << meniscus_last_error();
      const StepReport expected = world.step(dt);
      EXPECT_EQ(report.contacts, expected.contacts);
      EXPECT_EQ(report.emitted, expected.emitted);
      EXPECT_EQ(report.max_speed, expected.max_speed);
      uint64_t hash = 0;
      ASSERT_EQ(meniscus_state_hash(in_c, &hash), MENISCUS_OK);
      ASSERT_EQ(hash, world.state_hash()) << "step " << k;
    }
    double time = 0;
    EXPECT_EQ(meniscus_time(in_c, &time), MENISCUS_OK);
    EXPECT_EQ(time, world.time());
  }
};

TEST_P(CScenes, TankWithBody) {
  World world = empty_world();
  ShapeDef tank = shape(ContainerGeometry{{0.4f, 0.4f, 0.3f}, {{Face::y_high, {}}}});
  tank.name = "tank";
  world.create_shape(tank);
  BodyDef crate;
  crate.name = "crate";
  crate.geometry = BoxGeometry{{0.1f, 0.1f, 0.1f}};
  crate.pose.position = {0, 0.2f, 0};
  crate.mass = 4.0f;
  crate.surface.friction = 0.2f;
  const BodyId body = world.create_body(crate);
  world.add_fluid(block(viscous_water(world), {-0.4f, -0.4f, -0.3f}, {0.4f, 0.0f, 0.3f}));

  MeniscusWorld* made = nullptr;
  MeniscusId id{};
  ASSERT_EQ(c_tank_with_body(device(), &made, &id), MENISCUS_OK) << meniscus_last_error();
  const CWorld in_c(made);
  expect_equal(made, world, 12);

  MeniscusBodyState state{};
  state.size = sizeof state;
  ASSERT_EQ(meniscus_body_state(made, id, &state), MENISCUS_OK);
  EXPECT_EQ(state.pose.position.y, world.body_state(body).pose.position.y);
  EXPECT_EQ(state.fluid_force.y, world.body_state(body).fluid_force.y);

  const MeniscusVec3* positions = nullptr;
  std::size_t count = 0;
  ASSERT_EQ(meniscus_positions(made, &positions, &count), MENISCUS_OK);
  ASSERT_EQ(count, world.particle_count());
  EXPECT_EQ(positions[count - 1].y, world.positions()[count - 1].y);

  MeniscusDiagnostics diagnostics{};
  diagnostics.size = sizeof diagnostics;
  ASSERT_EQ(meniscus_diagnostics(made, &diagnostics), MENISCUS_OK);
  EXPECT_EQ(diagnostics.particles, count);
  EXPECT_EQ(diagnostics.kinetic_energy, world.diagnostics().kinetic_energy);

  const MeniscusParticleContact* contacts = nullptr;
  ASSERT_EQ(meniscus_particle_contacts(made, &contacts, &count), MENISCUS_OK);
  const std::vector<ParticleContact> expected = world.particle_contacts();
  ASSERT_EQ(count, expected.size());
  ASSERT_GT(count, 0u);
  EXPECT_EQ(contacts[0].particle, expected[0].particle);
  EXPECT_EQ(contacts[0].impulse.y, expected[0].impulse.y);

  MeniscusRayHit hit{};
  hit.size = sizeof hit;
  const MeniscusVec3 from = {state.pose.position.x, 0.39f, state.pose.position.z},
                     to = {from.x, -0.3f, from.z};
  ASSERT_EQ(meniscus_cast_ray(made, from, to, MENISCUS_ALL, &hit), MENISCUS_OK);
  EXPECT_EQ(hit.is_hit, 1);
  EXPECT_EQ(hit.thing.kind, uint32_t{MENISCUS_BODY});
  EXPECT_EQ(hit.thing.index, id.index);

  MeniscusSurfaceMesh mesh{};
  mesh.size = sizeof mesh;
  ASSERT_EQ(meniscus_surface_mesh(made, nullptr, &mesh), MENISCUS_OK);
  EXPECT_EQ(mesh.triangle_count, world.surface_mesh().triangles.size());
  EXPECT_GT(mesh.triangle_count, 0u);
}

TEST_P(CScenes, ClothOverBall) {
  World world = empty_world();
  ShapeDef ball = shape(SphereGeometry{0.3f});
  ball.surface.friction = 0.5f;
  world.create_shape(ball);
  ClothDef sheet;
  sheet.geometry = SheetGeometry{.columns = 17, .rows = 17};
  sheet.pose.position = {0, 0.35f, 0};
  sheet.fabric.density = 0.3f;
  sheet.fabric.stretch_model = StretchModel::triangles;
  sheet.tethers = false;
  const ClothId cloth = world.create_cloth(sheet);

  MeniscusWorld* made = nullptr;
  MeniscusId id{};
  ASSERT_EQ(c_cloth_over_ball(device(), &made, &id), MENISCUS_OK) << meniscus_last_error();
  const CWorld in_c(made);
  expect_equal(made, world, 12);

  const MeniscusVec3* normals = nullptr;
  std::size_t count = 0;
  ASSERT_EQ(meniscus_cloth_normals(made, id, &normals, &count), MENISCUS_OK);
  ASSERT_EQ(count, 17u * 17u);
  EXPECT_EQ(normals[40].y, world.cloth_normals(cloth)[40].y);
  MeniscusClothState state{};
  state.size = sizeof state;
  ASSERT_EQ(meniscus_cloth_state(made, id, &state), MENISCUS_OK);
  EXPECT_EQ(state.max_stretch, world.cloth_state(cloth).max_stretch);
}

TEST_P(CScenes, EmitterAndSink) {
  World world = empty_world();
  EmitterDef jet;
  jet.fluid = viscous_water(world);
  jet.opening = DiscOpening{0.15f};
  jet.pose.rotation = {1, 0, 0, 0};
  jet.speed = 2;
  jet.most_particles = 1000;
  const EmitterId emitter = world.create_emitter(jet);
  SinkDef drain;
  drain.region = HalfSpaceRegion{.offset = -0.3f};
  const SinkId sink = world.create_sink(drain);

  MeniscusWorld* made = nullptr;
  MeniscusId emitter_id{}, sink_id{};
  ASSERT_EQ(c_emitter_and_sink(device(), &made, &emitter_id, &sink_id), MENISCUS_OK) << meniscus_last_error();
  const CWorld in_c(made);
  expect_equal(made, world, 15);

  uint32_t last = 0;
  uint64_t total = 0;
  ASSERT_EQ(meniscus_flow_count(made, emitter_id, &last, &total), MENISCUS_OK);
  EXPECT_EQ(total, world.emitter_count(emitter).total);
  ASSERT_EQ(meniscus_flow_count(made, sink_id, &last, &total), MENISCUS_OK);
  EXPECT_EQ(total, world.sink_count(sink).total);
  EXPECT_GT(total, 0u);
}

MENISCUS_ON_EACH_DEVICE(CScenes);

}  // namespace
}  // namespace meniscus::tests
