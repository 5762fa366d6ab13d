// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A run that makes each call of World that changes it.
#include "tests/unit/sdk/world/recording/all_calls.h"

#include "tests/cloth_worlds.h"

namespace meniscus::tests {

namespace {

constexpr float dt = 0.01f;

BodyDef small_box(Vec3 at) {
  BodyDef def;
  def.geometry = BoxGeometry{{0.1f, 0.1f, 0.1f}};
  def.pose.position = at;
  return def;
}

void call_on_materials(World& world) {
  FluidDef water;
  water.name = "second";
  const FluidId fluid = world.create_fluid(water);
  water.xsph = 12.5f;
  world.set_fluid(fluid, water);
  world.create_granular({});
  world.add_fluid(block(fluid, {0.1f, 0.8f, 0.1f}, {0.4f, 1.1f, 0.4f}));
  const ParticleId first =
      world.add_particles(fluid, std::vector<Vec3>{{0.7f, 1.2f, 0.7f}, {0.2f, 1.4f, 0.7f}},
                          std::vector<Vec3>{{0.1f, 0, 0}, {0, -1, 0.3f}});
  world.step(dt);
  const std::vector<ParticleId> pair{first, first + 1};
  world.apply_impulses(pair, std::vector<Vec3>{{0.1f, 0, 0}, {0, 0.2f, 0}});
  world.set_positions(pair, std::vector<Vec3>{{0.7f, 1.3f, 0.7f}, {0.2f, 1.45f, 0.7f}});
  world.set_velocities(pair, std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}});
  world.step(dt);
  world.remove_particles(std::vector<ParticleId>{first});
  world.relax(1);
  world.set_velocities(world.velocities());  // a read-out of the world itself
  world.set_positions(copy_of(world.positions()));
  size_t of_second = 0;
  for (const uint32_t index : world.fluids()) of_second += index == fluid.index;
  std::vector<Vec3> places = lattice(10, 20, 10, 0.1f, {0, 0.8f, 0});
  places.resize(of_second);
  world.set_positions(fluid, places);
  world.set_velocities(fluid, std::vector<Vec3>(of_second, {0, -0.5f, 0}));
  world.set_filter(fluid, {3, 0xffff});
  world.step(dt);
}

void call_on_solids(World& world) {
  const ShapeId ball = world.create_shape(shape(SphereGeometry{0.1f}, {0.5f, 0.2f, 0.5f}));
  world.set_shape_pose(ball, {{0.4f, 0.2f, 0.5f}, {0, 0, 0, 1}});
  SurfaceDef rough;
  rough.friction = 0.4f;
  rough.slip_length = 0.01f;
  world.set_surface(ball, rough);
  world.set_filter(ball, {1, 7});
  const BodyId body = world.create_body(small_box({0.8f, 1.8f, 0.5f}));
  const BodyId other = world.create_body(small_box({0.5f, 1.8f, 0.5f}));
  BodyDef moved = small_box({0.2f, 2.2f, 0.2f});
  moved.motion = BodyMotion::kinematic;
  const BodyId plate = world.create_body(moved);
  JointDef hinge;
  hinge.a = body;
  hinge.b = other;
  hinge.frame.position = {0.65f, 1.8f, 0.5f};
  const JointId joint = world.create_joint(hinge);
  world.set_body_velocity(body, {0.1f, 0, 0}, {0, 1, 0});
  world.apply_force(body, {0, 5, 0}, {0.8f, 1.9f, 0.5f});
  world.apply_force(other, {0, 3, 0});
  world.apply_torque(body, {0.1f, 0, 0});
  world.apply_impulse(other, {0.2f, 0, 0}, {0.5f, 1.85f, 0.5f});
  world.move_body(plate, {{0.3f, 2.2f, 0.2f}, {0, 0, 0, 1}}, 0.1f);
  world.set_surface(body, rough);
  world.set_filter(body, {1, 5});
  world.step(dt);
  world.set_body_pose(body, {{0.8f, 1.9f, 0.5f}, {0, 0, 0, 1}});
  world.destroy_joint(joint);
  world.destroy_shape(ball);
  world.destroy_body(other);
  world.step(dt);
}

void call_on_cloth(World& world) {
  const ClothId cloth = world.create_cloth(sheet(0.3f, 0.3f, 4, 4, {0.5f, 2.5f, 0.5f}));
  const RopeId cord = world.create_rope(rope({{0.2f, 2.6f, 0.8f}, {0.8f, 2.6f, 0.8f}}, 6));
  const AttachmentId held = world.create_attachment(attach(cloth, {0, 3}));
  world.set_wind({.velocity = {1, 0, 0}});
  world.step(dt);
  world.apply_impulses(cloth, std::vector<uint32_t>{5}, std::vector<Vec3>{{0, 1e-4f, 0}});
  world.apply_impulses(cord, std::vector<uint32_t>{2}, std::vector<Vec3>{{0, 1e-4f, 0}});
  world.set_cloth_velocities(cloth, std::vector<Vec3>(16, {0, 0.1f, 0}));
  world.set_rope_velocities(cord, std::vector<Vec3>(7, {0, 0.1f, 0}));
  std::vector<Vec3> sheet_at = copy_of(world.cloth_positions(cloth)),
                    cord_at = copy_of(world.rope_positions(cord));
  for (Vec3& p : sheet_at) p.x += 0.05f;
  for (Vec3& p : cord_at) p.y += 0.05f;
  world.set_cloth_positions(cloth, sheet_at);
  world.set_rope_positions(cord, cord_at);
  world.set_filter(cloth, {1, 3});
  world.set_filter(cord, {1, 3});
  world.step(dt);
  world.destroy_attachment(held);
  const ClothId gone = world.create_cloth(sheet(0.2f, 0.2f, 3, 3, {0, 3, 0}));
  world.destroy_cloth(gone);
  world.destroy_rope(cord);
  world.step(dt);
}

void call_on_the_rest(World& world) {
  EmitterDef jet;
  jet.fluid = world.fluid_ids()[0];
  jet.pose.position = {0.5f, 1.5f, 0.5f};
  const EmitterId emitter = world.create_emitter(jet);
  SinkDef drain;
  drain.region = HalfSpaceRegion{{0, 1, 0}, 0.05f};
  const SinkId sink = world.create_sink(drain);
  const ProbeId probe = world.create_probe({});
  ForceFieldDef pull;
  pull.force = RadialForce{};
  const ForceFieldId field = world.create_force_field(pull);
  pull.force = NoiseForce{};
  world.set_force_field(field, pull);
  WorldDef def = world.def();
  def.gravity = {0, -5, 0.5f};
  def.iterations = 4;
  world.set_def(def);
  run(world, 2, dt);
  world.destroy_emitter(emitter);
  world.destroy_sink(sink);
  world.destroy_probe(probe);
  world.destroy_force_field(field);
  world.step(dt);
}

}  // namespace

World make_for_all_calls(const WorldDef& def) {
  World world(def);
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {1, 3, 1}));
  world.add_fluid(block(water, {0, 0, 0}, {1, 0.3f, 1}));
  world.step(dt);
  return world;
}

void make_all_calls(World& world) {
  call_on_materials(world);
  call_on_solids(world);
  call_on_cloth(world);
  call_on_the_rest(world);
}

}  // namespace meniscus::tests
