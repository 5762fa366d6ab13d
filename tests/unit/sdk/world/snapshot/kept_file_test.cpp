// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A snapshot file of a release on the CPU that is kept here. Later programs, on each kind of device, load it
// and go on as a world does that was not saved. After an intended change of the format,
// MENISCUS_RENEW_SNAPSHOT=1 snapshot_tests --gtest_filter='*Kept*cpu' writes it again.
#include <cstdlib>
#include <filesystem>

#include "tests/unit/sdk/world/snapshot/cases.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

namespace fs = std::filesystem;

constexpr int before = 10, after = 10;

const fs::path kept = fs::path(MENISCUS_KEPT_SNAPSHOTS) / "kept_0.2_cpu.menisnap";

/// Water, a floating box, held cloth and a rope.
World make(pbd::DeviceKind device) {
  WorldDef def = world_def(device, 0.1f);
  def.threads = 1;
  World world(def);
  world.create_shape(tank({0, 0, 0}, {0.8f, 1, 0.4f}));
  FluidDef water;
  water.xsph = 20;
  world.add_fluid(block(world.create_fluid(water), {0, 0, 0}, {0.8f, 0.4f, 0.4f}));
  BodyDef box = body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0.4f, 0.5f, 0.2f});
  box.name = "box";
  box.density = 400;
  world.create_body(box);
  const ClothId cloth = world.create_cloth(sheet(0.3f, 0.3f, 4, 4, {2, 1, 0}));
  world.create_attachment(attach(cloth, {0, 3}));
  world.create_rope(rope({{2, 1, 1}, {2.3f, 1, 1}}, 3));
  run(world, before, snapshot_step);
  return world;
}

Vec3 mean(std::span<const Vec3> points) {
  Vec3 sum{0, 0, 0};
  for (const Vec3 p : points) sum += p;
  return sum / static_cast<float>(points.size());
}

class KeptSnapshotTest : public OnDevice {};

TEST_P(KeptSnapshotTest, GoesOnAsAWorldThatWasNotSaved) {
  const char* renew = std::getenv("MENISCUS_RENEW_SNAPSHOT");
  if (renew && *renew == '1' && GetParam() == pbd::DeviceKind::cpu) make(GetParam()).save(kept);
  ASSERT_LT(fs::file_size(kept), 200'000u);
  World world = make(GetParam());
  LoadDef here;
  here.device = choice_of(GetParam());
  World loaded = World::load(kept, here);
  EXPECT_NEAR(loaded.time(), world.time(), 1e-9);
  EXPECT_EQ(loaded.particle_count(), world.particle_count());
  run(world, after, snapshot_step), run(loaded, after, snapshot_step);
  // 20 steps of a moving pool: devices and compilers round differently.
  expect_near(mean(loaded.positions()), mean(world.positions()), 2e-3f);
  EXPECT_NEAR(energy(loaded), energy(world), 0.02 * std::abs(energy(world)));
  const BodyState a = loaded.body_state(loaded.find_body("box")),
                  b = world.body_state(world.find_body("box"));
  expect_near(a.pose.position, b.pose.position, 5e-3f);
  expect_near(a.velocity, b.velocity, 0.1f);
  const ClothId cloth = loaded.find_cloth("sheet"), cloth_of_world = world.find_cloth("sheet");
  for (uint32_t v = 0; v < 16; ++v)
    expect_near(loaded.cloth_positions(cloth)[v], world.cloth_positions(cloth_of_world)[v], 1e-3f);
  const RopeId string = loaded.find_rope("rope"), string_of_world = world.find_rope("rope");
  for (uint32_t v = 0; v < 4; ++v)
    expect_near(loaded.rope_positions(string)[v], world.rope_positions(string_of_world)[v], 1e-3f);
}

MENISCUS_ON_EACH_DEVICE(KeptSnapshotTest);

}  // namespace
}  // namespace meniscus::tests
