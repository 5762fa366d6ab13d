// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth of a world in a batch moves bit for bit as that of a world alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/batch_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = batch_dt;

ClothDef without_self_collision(ClothDef cloth) {
  cloth.self_collision = false;
  return cloth;
}

/// A disc of triangles, whose rows of edges have unequal lengths.
ClothDef disc(float radius, Vec3 position) {
  ClothTriangles mesh;
  constexpr int rings = 4;
  mesh.vertices.push_back({0, 0, 0});
  for (int ring = 1; ring <= rings; ++ring) {
    for (int k = 0; k < 6 * ring; ++k) {
      const float angle = 6.2831853f * static_cast<float>(k) / static_cast<float>(6 * ring);
      const float r = radius * static_cast<float>(ring) / rings;
      mesh.vertices.push_back({r * std::cos(angle), 0, r * std::sin(angle)});
    }
  }
  const auto at = [](int ring, int k) {
    return ring == 0 ? 0u : static_cast<uint32_t>(1 + 3 * ring * (ring - 1) + (k % (6 * ring)));
  };
  for (int ring = 1; ring <= rings; ++ring) {
    for (int sector = 0; sector < 6; ++sector) {
      for (int k = 0; k < ring; ++k) {
        const int out = sector * ring + k, in = sector * (ring - 1) + k;
        mesh.triangles.insert(mesh.triangles.end(), {at(ring, out), at(ring, out + 1), at(ring - 1, in)});
        if (k + 1 < ring)
          mesh.triangles.insert(mesh.triangles.end(),
                                {at(ring, out + 1), at(ring - 1, in + 1), at(ring - 1, in)});
      }
    }
  }
  ClothDef made;
  made.geometry = mesh;
  made.pose.position = position;
  return made;
}

/// Water that falls on a sheet held at its corners; a sheet with strains of triangles and dihedral bending,
/// whose edge is sewn to it; a disc that falls on a ball; a balloon; gusts.
World washing(WorldDef def) {
  def.particle_spacing = 0.06f;
  World world(def);
  const FluidId water = world.create_fluid({});
  ShapeDef walls = tank({0, 0, 0}, {1, 1, 0.5f});
  std::get<ContainerGeometry>(walls.geometry).openings = {{Face::y_high}};
  walls.surface.friction = 0.5f;
  world.create_shape(walls);
  world.create_shape(shape(SphereGeometry{0.12f}, {0.8f, 0.12f, 0.25f}));
  const ClothId net =
      world.create_cloth(without_self_collision(sheet(0.4f, 0.4f, 9, 7, {0.3f, 0.35f, 0.25f})));
  world.create_attachment(attach(net, {0, 8, 54, 62}));
  ClothDef flap = without_self_collision(sheet(0.2f, 0.4f, 5, 7, {0.6f, 0.35f, 0.25f}));
  flap.fabric.stretch_model = StretchModel::triangles;
  flap.fabric.bending_model = BendingModel::dihedral;
  const ClothId other = world.create_cloth(flap);
  AttachmentDef seam = attach(other, {0, 5, 10, 15, 20, 25, 30});
  seam.other_cloth = net;
  world.create_attachment(seam);
  world.create_cloth(without_self_collision(disc(0.16f, {0.8f, 0.3f, 0.25f})));
  ClothDef balloon;
  balloon.geometry = ClothSphere{0.08f, 3};
  balloon.pose.position = {0.15f, 0.8f, 0.25f};
  balloon.inflation = InflationDef{300, 101325};
  world.create_cloth(without_self_collision(balloon));
  world.add_fluid(block(water, {0.15f, 0.4f, 0.1f}, {0.45f, 0.6f, 0.4f}));
  world.set_wind({.velocity = {1, 0, 0.5f}, .gust_speed = 1});
  return world;
}

/// A sheet that falls on its edge and folds, and two that fly at one another, one of them fast.
World folding(const WorldDef& def) {
  World world(def);
  world.create_shape(tank({0, 0, 0}, {2, 2, 1}));
  ClothDef curtain = sheet(0.5f, 0.3f, 11, 7, {0.4f, 0.3f, 0.5f});
  curtain.pose.rotation = about_z(85);
  world.create_cloth(curtain);
  ClothDef left = sheet(0.3f, 0.3f, 7, 7, {1, 0.6f, 0.5f}),
           right = sheet(0.4f, 0.2f, 9, 5, {1.3f, 0.65f, 0.5f});
  left.pose.rotation = right.pose.rotation = about_z(80);
  left.velocity = {1, 0, 0};
  right.velocity = {-12, 1, 0};
  world.create_cloth(left);
  world.create_cloth(right);
  return world;
}

class BatchClothTest : public BatchOnDevice {
 protected:
  World archetype(const WorldDef& def) const override { return washing(def); }
};

TEST_P(BatchClothTest, AWorldIsAsItIsAlone) {
  expect_as_alone(1, 2, 1, 40);
  expect_as_alone(7, 0, 1, 40);
}

TEST_P(BatchClothTest, SoItIsAtAnyPlaceAmongMany) {
  expect_as_alone(many(), 3, 2, 10);
}

TEST_P(BatchClothTest, WaterAndClothMeet) {
  WorldBatch made = batch(2);
  run_batch(made, 40);
  ASSERT_EQ(made.cloth_positions().size(), 2 * made.vertex_count());
  const float middle = made.cloth_positions()[31].y;
  EXPECT_LT(middle, 0.33f) << "the water bends the sheet";
  EXPECT_GT(middle, 0.1f) << "the sheet holds";
  const size_t in_sheet = static_cast<size_t>(std::count_if(made.positions().begin(),
                                                            made.positions().begin() + made.particle_count(),
                                                            [](Vec3 p) { return p.y > 0.15f; }));
  EXPECT_GT(in_sheet, made.particle_count() / 2) << "the sheet carries water";
}

TEST_P(BatchClothTest, ReadOutsAreThoseOfAWorldAlone) {
  WorldBatch made = batch(3);
  run_batch(made, 20);
  World own = of_kind(1);
  run(own, 20, dt);
  size_t first = made.vertex_count();
  for (const ClothId id : own.cloth_ids()) {
    const std::span<const Vec3> expected = own.cloth_positions(id);
    for (size_t v = 0; v < expected.size(); ++v)
      EXPECT_EQ(made.cloth_positions()[first + v], expected[v]) << "vertex " << v;
    first += expected.size();
  }
  EXPECT_EQ(first, 2 * made.vertex_count());
  const BatchArrays arrays = made.device_arrays();
  EXPECT_EQ(arrays.cloth_positions.shape[1], static_cast<int64_t>(made.vertex_count()));
  if (arrays.cloth_positions.on_cuda) return;
  const auto* const velocities = static_cast<const Vec3*>(arrays.cloth_velocities.data);
  EXPECT_TRUE(std::equal(made.cloth_velocities().begin(), made.cloth_velocities().end(), velocities));
}

TEST_P(BatchClothTest, AResetWorldIsAFreshOne) {
  WorldBatch made = batch(4);
  run_batch(made, 20);
  made.reset(mask_of(4, {1, 3}));
  EXPECT_EQ(made.state_hashes()[3], of_kind(3).state_hash());
  run_batch(made, 100);
  for (uint32_t w = 0; w < 4; ++w)
    EXPECT_EQ(made.state_hashes()[w], alone(w, w % 2 ? 100 : 120)) << "world " << w;
}

/// Warm starts of edges, anchors of vertices that stick, and the time of gusts are of that state.
TEST_P(BatchClothTest, StartsInAnyState) {
  World world = archetype(def());
  run(world, 30, dt);
  WorldBatch made(world, {3});
  EXPECT_EQ(made.state_hashes()[2], world.state_hash());
  run_batch(made, 15);
  made.reset(mask_of(3, {1}));
  EXPECT_EQ(made.state_hashes()[1], world.state_hash());
  run(world, 15, dt);
  EXPECT_EQ(made.state_hashes()[0], world.state_hash());
  run_batch(made, 15);
  EXPECT_EQ(made.state_hashes()[1], world.state_hash());
  run(world, 15, dt);
  EXPECT_EQ(made.state_hashes()[2], world.state_hash());
}

TEST_P(BatchClothTest, AnExtractedWorldGoesOn) {
  WorldBatch made = batch(7);
  run_batch(made, 25);
  World world = made.extract(3);
  EXPECT_EQ(world.state_hash(), made.state_hashes()[3]);
  run(world, 15, dt);
  EXPECT_EQ(world.state_hash(), alone(3, 40));
}

TEST_P(BatchClothTest, ASnapshotGoesOn) {
  WorldBatch made = batch(3);
  run_batch(made, 20);
  const BatchSnapshot then = made.snapshot();
  run_batch(made, 15);
  const std::vector<uint64_t> expected(made.state_hashes().begin(), made.state_hashes().end());
  made.restore(then);
  run_batch(made, 15);
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), made.state_hashes().begin()));
}

TEST_P(BatchClothTest, AWorldThatFailsGoesBackAlone) {
  WorldBatch made = batch(5);
  run_batch(made, 15);
  const uint64_t before = made.state_hashes()[4];
  made.set_gravity(4, {0, 1e30f, 0});
  EXPECT_EQ(made.step(dt).failed, 1u);
  EXPECT_EQ(made.state_hashes()[4], before);
  run_batch(made, 10);
  for (uint32_t w = 0; w < 4; ++w) EXPECT_EQ(made.state_hashes()[w], alone(w, 26)) << "world " << w;
  made.set_gravity(4, gravity_of(4));
  made.reset(mask_of(5, {4}));
  run_batch(made, 10);
  EXPECT_EQ(made.state_hashes()[4], alone(4, 10));
}

TEST_P(BatchClothTest, APausedWorldStays) {
  WorldBatch made = batch(3);
  const std::vector<uint8_t> mask{1, 0, 1};
  run_batch(made, 10);
  made.set_active(mask);
  run_batch(made, 10);
  made.set_active(std::vector<uint8_t>(3, 1));
  run_batch(made, 10);
  for (uint32_t w = 0; w < 3; ++w)
    EXPECT_EQ(made.state_hashes()[w], alone(w, mask[w] ? 30 : 20)) << "world " << w;
}

TEST_P(BatchClothTest, AWarmStepAllocatesNothing) {
  WorldBatch made = batch(3);
  run_batch(made, 60);
  made.reset(mask_of(3, {1}));
  run_batch(made, 5);
  const size_t before = made.memory_stats().device.allocations;
  made.reset(mask_of(3, {1, 2}));
  run_batch(made, 5);
  EXPECT_EQ(made.memory_stats().device.allocations, before);
}

/// Without fluid as well.
TEST_P(BatchClothTest, ClothMayBeAlone) {
  const auto flag = [&](Vec3 gravity) {
    WorldDef own = def();
    own.gravity = gravity;
    World world(own);
    const ClothId cloth = world.create_cloth(without_self_collision(sheet(0.5f, 0.5f, 8, 8, {0, 1, 0})));
    world.create_attachment(attach(cloth, {0, 7}));
    return world;
  };
  WorldBatch made(flag(gravity_of(0)), {3});
  made.set_gravities(std::vector<Vec3>{gravity_of(0), gravity_of(1), gravity_of(2)});
  run_batch(made, 30);
  for (uint32_t w = 0; w < 3; ++w) {
    World own = flag(gravity_of(w));
    run(own, 30, dt);
    EXPECT_EQ(made.state_hashes()[w], own.state_hash());
  }
}

TEST_P(BatchClothTest, NamesWhatItDoesNotTake) {
  const auto expect_refused = [&](const char* what, const auto& change) {
    World world = archetype(def());
    change(world);
    const std::string refusal = refusal_of([&] { WorldBatch(world, {2}); });
    EXPECT_NE(refusal.find(what), std::string::npos) << refusal;
  };
  const auto expect_cloth_refused = [&](const char* what, const auto& change) {
    expect_refused(what, [&](World& w) {
      ClothDef cloth = without_self_collision(sheet(0.2f, 0.2f, 4, 4, {0.5f, 0.9f, 0.25f}));
      change(cloth);
      w.create_cloth(cloth);
    });
  };
  expect_cloth_refused("tear_strain", [](ClothDef& c) { c.fabric.tear_strain = 0.2f; });
  expect_cloth_refused("absorbency", [](ClothDef& c) { c.fabric.absorbency = 0.2f; });
  expect_cloth_refused("permittivity", [](ClothDef& c) { c.fabric.permittivity = 0.2f; });
  expect_refused("bodies", [](World& w) {
    w.create_body(validation::body(SphereGeometry{0.05f}, {0.5f, 0.9f, 0.25f}, 900));
  });
}

TEST_P(BatchClothTest, AnInsertedWorldGoesOn) {
  WorldBatch made = batch(3);
  run_batch(made, 5);
  World other = of_kind(4);
  run(other, 20, dt);
  made.insert(1, other);
  EXPECT_EQ(made.state_hashes()[1], other.state_hash());
  run(other, 20, dt);
  run_batch(made, 20);
  EXPECT_EQ(made.state_hashes()[1], other.state_hash());
  EXPECT_EQ(made.state_hashes()[2], alone(2, 25));
  made.reset(mask_of(3, {1}));
  EXPECT_EQ(made.state_hashes()[1], archetype(def()).state_hash());
  World fewer = of_kind(0);
  fewer.destroy_cloth(fewer.cloth_ids().back());
  EXPECT_NE(refusal_of([&] { made.insert(0, fewer); }).find("pieces of cloth"), std::string::npos);
}

class BatchFoldingTest : public BatchOnDevice {
 protected:
  World archetype(const WorldDef& def) const override { return folding(def); }
};

TEST_P(BatchFoldingTest, AWorldIsAsItIsAlone) {
  expect_as_alone(1, 2, 1, 40);
  expect_as_alone(7, 0, 1, 40);
}

TEST_P(BatchFoldingTest, SoItIsAtAnyPlaceAmongMany) {
  expect_as_alone(many(), 3, 2, 10);
}

TEST_P(BatchFoldingTest, AResetWorldIsAFreshOne) {
  WorldBatch made = batch(4);
  run_batch(made, 25);
  made.reset(mask_of(4, {1, 3}));
  run_batch(made, 60);
  for (uint32_t w = 0; w < 4; ++w)
    EXPECT_EQ(made.state_hashes()[w], alone(w, w % 2 ? 60 : 85)) << "world " << w;
}

/// How far vertices stray, and how long lists last, are of that state.
TEST_P(BatchFoldingTest, StartsInAnyStateAndIsExtracted) {
  World world = archetype(def());
  run(world, 20, dt);
  WorldBatch made(world, {3});
  run_batch(made, 10);
  World taken = made.extract(2);
  made.reset(mask_of(3, {1}));
  EXPECT_EQ(made.state_hashes()[1], world.state_hash());
  run_batch(made, 10);
  run(taken, 10, dt);
  run(world, 10, dt);
  EXPECT_EQ(made.state_hashes()[1], world.state_hash());
  run(world, 10, dt);
  EXPECT_EQ(made.state_hashes()[0], world.state_hash());
  EXPECT_EQ(taken.state_hash(), world.state_hash());
}

TEST_P(BatchFoldingTest, PausesFailuresAndSnapshotsAreThoseOfOneWorld) {
  WorldBatch made = batch(4);
  run_batch(made, 10);
  made.set_active(std::vector<uint8_t>{1, 0, 1, 1});
  run_batch(made, 5);
  made.set_active(std::vector<uint8_t>(4, 1));
  made.set_gravity(3, {0, 1e30f, 0});
  EXPECT_EQ(made.step(dt).failed, 1u);
  const BatchSnapshot then = made.snapshot();
  run_batch(made, 9);
  made.restore(then);
  run_batch(made, 9);
  EXPECT_EQ(made.state_hashes()[0], alone(0, 25));
  EXPECT_EQ(made.state_hashes()[1], alone(1, 20));
  EXPECT_EQ(made.state_hashes()[2], alone(2, 25));
  EXPECT_EQ(made.state_hashes()[3], alone(3, 15));
}

TEST_P(BatchFoldingTest, AWarmStepAllocatesNothing) {
  WorldBatch made = batch(4);
  for (int k = 0; k < 3; ++k) {
    run_batch(made, 40);
    made.reset();
  }
  const size_t before = made.memory_stats().device.allocations;
  run_batch(made, 30);
  made.reset(mask_of(4, {1, 3}));
  run_batch(made, 5);
  EXPECT_EQ(made.memory_stats().device.allocations, before);
}

/// The room of lists is that of the world with most, and all worlds have it.
TEST_P(BatchFoldingTest, MemoryIsLinearInWorlds) {
  const auto bytes = [&](uint32_t worlds) {
    WorldBatch made = batch(worlds, 0, 0);
    run_batch(made, 25);
    return static_cast<double>(made.memory_stats().device.bytes);
  };
  const double few = bytes(8), more = bytes(16), many = bytes(32);
  EXPECT_NEAR((many - more) / (2 * (more - few)), 1, 0.1);
}

MENISCUS_ON_EACH_DEVICE(BatchClothTest);
MENISCUS_ON_EACH_DEVICE(BatchFoldingTest);

}  // namespace
}  // namespace meniscus::tests
