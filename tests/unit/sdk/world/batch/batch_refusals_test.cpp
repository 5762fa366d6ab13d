// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a batch does not take is refused by name, when the batch is made.
#include <gtest/gtest.h>

#include "tests/unit/sdk/world/batch/batch_archetypes.h"
#include "tests/unit/sdk/world/batch/batch_worlds.h"

namespace meniscus::tests {
namespace {

class BatchRefusalsTest : public BatchOnDevice {
 protected:
  World archetype(const WorldDef& def) const override { return rigging(def).world; }

  static std::string refusal(const World& world, const BatchDef& batch = {2}) {
    return refusal_of([&] { WorldBatch(world, batch); });
  }
  template <class Change>
  void expect_refused(const char* what, const Change& change) const {
    World world = archetype(def());
    change(world);
    EXPECT_NE(refusal(world).find(what), std::string::npos) << refusal(world);
  }
  template <class Change>
  void expect_def_refused(const char* what, const Change& change) const {
    WorldDef other = def();
    change(other);
    World world(other);
    world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.5f, 0.5f, 0.5f}));
    EXPECT_NE(refusal(world).find(what), std::string::npos) << refusal(world);
  }
  template <class Change>
  void expect_cloth_refused(const char* what, const Change& change) const {
    expect_refused(what, [&](World& w) {
      ClothDef cloth = without_self_collision(sheet(0.2f, 0.2f, 4, 4, {0.5f, 0.9f, 0.25f}));
      change(cloth);
      w.create_cloth(cloth);
    });
  }
};

TEST_P(BatchRefusalsTest, AllThatIsHereIsTaken) {
  EXPECT_EQ(refusal(archetype(def())), "nothing was refused");
}

TEST_P(BatchRefusalsTest, PartsOfAWorld) {
  expect_refused("ropes", [](World& w) {
    RopeDef rope;
    rope.points = {{0.7f, 0.5f, 0.2f}, {0.7f, 0.8f, 0.2f}};
    w.create_rope(rope);
  });
  expect_refused("emitters", [](World& w) {
    EmitterDef emitter;
    emitter.fluid = w.fluid_ids().front();
    w.create_emitter(emitter);
  });
  expect_refused("sinks", [](World& w) { w.create_sink({}); });
  expect_refused("probes", [](World& w) { w.create_probe({}); });
  expect_refused("force fields", [](World& w) { w.create_force_field({}); });
  expect_refused("hooks", [](World& w) { w.add_hook(Hook::solved, [](const SubstepView&) {}); });
  expect_refused("dynamic_viscosity", [](World& w) {
    FluidDef thick;
    thick.dynamic_viscosity = 1;
    w.create_fluid(thick);
  });
}

TEST_P(BatchRefusalsTest, ClothThatTheHostChanges) {
  expect_cloth_refused("tear_strain", [](ClothDef& c) { c.fabric.tear_strain = 0.2f; });
  expect_cloth_refused("absorbency", [](ClothDef& c) { c.fabric.absorbency = 0.2f; });
  expect_cloth_refused("permittivity", [](ClothDef& c) { c.fabric.permittivity = 0.2f; });
  expect_cloth_refused("driven", [](ClothDef& c) {
    DrivenTriangles motion;
    motion.triangles = {0, 1, 2};
    motion.keyframes = {{0, {{0.5f, 0.9f, 0.2f}, {0.6f, 0.9f, 0.2f}, {0.5f, 0.9f, 0.3f}}}};
    c.geometry = motion;
  });
}

TEST_P(BatchRefusalsTest, Definitions) {
  expect_def_refused("sums", [](WorldDef& d) { d.sums = Sums::automatic; });
  expect_def_refused("diffuse", [](WorldDef& d) { d.diffuse.emplace(); });
  expect_def_refused("step_budget_ms", [](WorldDef& d) { d.step_budget_ms = 5; });
  expect_def_refused("cfl_number", [](WorldDef& d) { d.cfl_number = 0.4f; });
  expect_def_refused("density.tolerance", [](WorldDef& d) { d.density.tolerance = 0.01f; });
  expect_def_refused("density.solver", [](WorldDef& d) { d.density.solver = DensitySolver::grid; });
  expect_def_refused("rigid.solver", [](WorldDef& d) { d.rigid.solver = RigidSolver::device; });
}

TEST_P(BatchRefusalsTest, Numbers) {
  EXPECT_NE(refusal(World(def())).find("no particles"), std::string::npos);
  EXPECT_NE(refusal(archetype(def()), {0}).find("BatchDef::worlds"), std::string::npos);
  EXPECT_NE(refusal(archetype(def()), {2, -1}).find("BatchDef::rigid_threads"), std::string::npos);
}

MENISCUS_ON_EACH_DEVICE(BatchRefusalsTest);

}  // namespace
}  // namespace meniscus::tests
