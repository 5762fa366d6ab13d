// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Once warm, a step with cloth allocates nothing on the device: not even memory that is given back at once.
// The engine shows the device's own count.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/engines.h"

namespace meniscus::tests {
namespace {

/// A sheet of 1 m by 1 m that lies on the plane y = 0, with a corner held.
EngineCloth cloth_on_the_floor() {
  cloth::ClothMesh mesh = cloth::make_sheet(1, 1, 21, 21);
  EngineCloth all;
  all.model.constraints = cloth::build_constraints(mesh, {});
  const std::vector<float>& masses = all.model.constraints.masses;
  for (uint32_t v = 0; v < masses.size(); ++v) {
    const Vec3 x = mesh.vertices[v] + Vec3{0, 0.02f, 0};
    all.position.push_back(pbd::with_w(x, v ? 1 / masses[v] : 0));
    all.velocity.push_back({0, 0, 0, 0});
    all.phase.push_back(pbd::phase_vertex);
  }
  for (const auto& t : mesh.triangles) all.model.triangles.push_back({t[0], t[1], t[2], 0});
  all.model.rest = mesh.vertices;
  all.model.held = {0};
  cloth::Piece piece{.first_vertex = 0, .end_vertex = static_cast<uint32_t>(masses.size())};
  piece.drag = piece.lift = 1;
  all.model.pieces = {piece};
  all.touches = {{{}, 0.005f}};
  all.contact_pieces = {{0.01f, 0.3f, {}, true}};
  return all;
}

class ClothAllocationTest : public OnDevice {};

TEST_P(ClothAllocationTest, AWarmStepAllocatesNothingOnTheDevice) {
  collision::RigidWorld rigid({});
  const std::unique_ptr<Engine> engine = make_engine_on(GetParam(), engine_def(rigid));
  engine->set_materials(std::vector<ParticleMaterial>{{{1000, 0, 5, 0, 0, 0}, {}, {}}});
  SolidShapes solids;
  solids.shapes.resize(1);  // y > 0
  solids.fixed = 1;
  engine->set_shapes(solids);
  engine->set_cloth(cloth_on_the_floor());
  for (int k = 0; k < 60; ++k) engine->step(0.016f, 10);
  EXPECT_GT(engine->step(0.016f, 10).result.contacts, 200u);
  const uint64_t count = engine->device().memory().allocations;
  for (int k = 0; k < 30; ++k) engine->step(0.016f, 10);
  EXPECT_EQ(engine->device().memory().allocations, count);
}

TEST_P(ClothAllocationTest, AWorldsWarmStepHoldsTheSameMemory) {
  World world(world_def(GetParam(), engine_spacing));
  world.create_shape(tank({-0.5f, 0, -0.5f}, {0.5f, 2, 0.5f}));
  world.add_fluid(block(world.create_fluid({}), {-0.5f, 0, -0.5f}, {0.5f, 0.1f, 0.5f}));
  const ClothId net = world.create_cloth(sheet(0.8f, 0.8f, 15, 15, {0, 0.6f, 0}));
  world.create_attachment(attach(net, {0, 14, 210, 224}));
  const RopeId line = world.create_rope(rope({{0, 1.5f, 0}, {0, 1.2f, 0}}, 6));
  world.create_attachment(attach(line, {0}));
  run(world, 60, 0.016f);
  const size_t held = world.device_bytes();
  run(world, 40, 0.016f);
  EXPECT_EQ(world.device_bytes(), held);
}

TEST_P(ClothAllocationTest, WhatIsDestroyedLeavesNoMemoryBehind) {
  World world(world_def(GetParam(), engine_spacing));
  const auto come_and_go = [&] {
    const ClothId cloth = world.create_cloth(sheet(1, 1, 21, 21));
    const RopeId line = world.create_rope(rope({{2, 0, 0}, {3, 0, 0}}, 10));
    world.create_attachment(attach(cloth, {0}));
    world.step(0.016f);
    world.destroy_rope(line);
    world.destroy_cloth(cloth);
    world.step(0.016f);
  };
  come_and_go();
  const size_t held = world.device_bytes();
  for (int k = 0; k < 5; ++k) come_and_go();
  EXPECT_LE(world.device_bytes(), held);
}

MENISCUS_ON_EACH_DEVICE(ClothAllocationTest);

}  // namespace
}  // namespace meniscus::tests
