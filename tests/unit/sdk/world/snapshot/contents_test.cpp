// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A restore goes back over all that was created, destroyed and set since the snapshot.
#include <functional>
#include <map>

#include "tests/unit/sdk/world/snapshot/cases.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr int steps = 2;

void destroy_everything(World& world) {
  for (const AttachmentId id : world.attachment_ids()) world.destroy_attachment(id);
  for (const JointId id : world.joint_ids()) world.destroy_joint(id);
  for (const BodyId id : world.body_ids()) world.destroy_body(id);
  for (const ShapeId id : world.shape_ids()) world.destroy_shape(id);
  for (const ClothId id : world.cloth_ids()) world.destroy_cloth(id);
  for (const RopeId id : world.rope_ids()) world.destroy_rope(id);
  for (const EmitterId id : world.emitter_ids()) world.destroy_emitter(id);
  for (const SinkId id : world.sink_ids()) world.destroy_sink(id);
  for (const ProbeId id : world.probe_ids()) world.destroy_probe(id);
  world.remove_particles(std::vector<ParticleId>(world.ids().begin(), world.ids().end()));
}

void fill_with_others(World& world) {
  world.create_shape(shape(PlaneGeometry{}, {0, -3, 0}));
  world.create_shape(shape(SphereGeometry{0.5f}, {0, -2, 0}));
  const BodyId a = world.create_body(body(SphereGeometry{0.2f}, {0, 0, 0}));
  const BodyId b = world.create_body(body(BoxGeometry{{0.2f, 0.2f, 0.2f}}, {0, 0.39f, 0}));
  world.create_joint(joint(BallJoint{}, a, b));
  const ClothId cloth = world.create_cloth(sheet(0.3f, 0.3f, 4, 4, {0.3f, 1, 0}));
  AttachmentDef to_body = attach(cloth, {3});
  to_body.body = b;
  world.create_attachment(to_body);
  world.add_particles(world.create_fluid({}), lattice(3, 3, 3, 0.1f, {1, 0, 0}));
}

class SnapshotContentsTest : public OnDevice {
 protected:
  static void expect_way_back(World& world, const std::function<void()>& change) {
    const Snapshot snapshot = world.snapshot();
    const auto then = state_of(world);
    const auto future = future_of(world, steps);
    change();
    world.step(snapshot_step);
    world.restore(snapshot);
    EXPECT_EQ(state_of(world), then);
    EXPECT_EQ(future_of(world, steps), future);
    world.restore(snapshot);
  }
};

TEST_P(SnapshotContentsTest, BringsBackAllThatWasDestroyed) {
  for (const SnapshotCase& c : snapshot_cases()) {
    SCOPED_TRACE(c.name);
    World world = c.make(world_def(GetParam(), 0.1f));
    run(world, c.before, snapshot_step);
    const PeriodicDef periodic = world.def().periodic;  // which takes few things, as baselines do
    const bool takes_all =
        !periodic.x && !periodic.y && !periodic.z && !is_baseline(world.def().density.solver);
    expect_way_back(world, [&] {
      destroy_everything(world);
      if (takes_all) fill_with_others(world);
    });
  }
}

/// Fields of meshes and heights stay while a snapshot needs them.
TEST_P(SnapshotContentsTest, BringsBackMeshesAndHeights) {
  const TemporaryFolder folder;
  World world(world_def(GetParam(), 0.1f));
  const MeshGeometry brick{folder.write("brick.obj", brick_obj), 0.2f};
  const ShapeId fixed = world.create_shape(shape(brick, {-1, 0, 0}));
  HeightFieldGeometry hills{9, 9, 0.25f, {}};
  for (int k = 0; k < 81; ++k) hills.heights.push_back(0.1f * static_cast<float>(k % 3));
  const ShapeId ground = world.create_shape(shape(hills, {0, -0.5f, 0}));
  const BodyId falling = world.create_body(body(brick, {0, 0.5f, 0}));
  world.add_particles(world.create_fluid({}), lattice(6, 3, 6, 0.1f, {-0.6f, 0, -0.3f}));
  run(world, 10, snapshot_step);
  expect_way_back(world, [&] {
    world.destroy_shape(fixed), world.destroy_shape(ground), world.destroy_body(falling);
    world.step(snapshot_step);  // their places are free
    world.create_shape(shape(MeshGeometry{brick.file, 0.1f}, {0, -1, 0}));
  });
  world.step(snapshot_step);
  EXPECT_EQ(world.shape_ids(), (std::vector<ShapeId>{fixed, ground}));
}

TEST_P(SnapshotContentsTest, IdsAreThoseOfThen) {
  World world = dam_break(GetParam());
  const Snapshot snapshot = world.snapshot();
  const ShapeId tank_then = world.find_shape("tank");
  world.destroy_shape(tank_then);
  const ShapeId later = world.create_shape(shape(SphereGeometry{0.1f}));
  const BodyId late_body = world.create_body(body(SphereGeometry{0.1f}, {0.8f, 0.8f, 0.2f}));
  world.restore(snapshot);
  EXPECT_EQ(world.find_shape("tank"), tank_then);
  expect_error(ErrorCode::not_found, "no shape", [&] { world.destroy_shape(later); });
  expect_error(ErrorCode::not_found, "no body", [&] { world.body_state(late_body); });
  EXPECT_TRUE(world.body_ids().empty());
}

/// Each setter by itself, in a world that has one of each.
TEST_P(SnapshotContentsTest, BringsBackWhatWasSet) {
  World world(world_def(GetParam(), 0.1f));
  const ShapeId floor = world.create_shape(shape(BoxGeometry{{1, 0.1f, 1}}, {0, 0, 0}));
  world.create_shape(shape(PlaneGeometry{}, {0, -1, 0}));
  const BodyId box = world.create_body(body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0.5f, 0.2f, 0}));
  const FluidId water = world.create_fluid({});
  world.add_particles(water, lattice(4, 3, 4, 0.1f, {-0.4f, 0.1f, -0.2f}));
  const ClothId cloth = world.create_cloth(sheet(0.4f, 0.4f, 5, 5, {-0.2f, 0.8f, 0}));
  const RopeId string = world.create_rope(rope({{0, 0.5f, 0.7f}, {0.5f, 0.5f, 0.7f}}, 4));
  run(world, 20, snapshot_step);
  const std::vector<Vec3> many(1000, {0.1f, 0.7f, 0.1f});
  SurfaceDef slippery;
  slippery.solid_friction = 0;
  slippery.friction = 0.7f;
  const auto first = [&](size_t count) { return std::span(many).first(count); };
  std::vector<Vec3> apart;
  for (const Vec3 p : world.positions()) apart.push_back(p + Vec3{0, 0.4f, 0});
  const std::map<const char*, std::function<void()>> setters{
      {"positions", [&] { world.set_positions(apart); }},
      {"velocities", [&] { world.set_velocities(first(world.particle_count())); }},
      {"cloth velocities", [&] { world.set_cloth_velocities(cloth, first(25)); }},
      {"rope velocities", [&] { world.set_rope_velocities(string, first(5)); }},
      {"cloth positions",
       [&] {
         std::vector<Vec3> lower = copy_of(world.cloth_positions(cloth));
         for (Vec3& p : lower) p.y -= 0.1f;
         world.set_cloth_positions(cloth, lower);
       }},
      {"rope positions",
       [&] {
         std::vector<Vec3> lower = copy_of(world.rope_positions(string));
         for (Vec3& p : lower) p.y -= 0.1f;
         world.set_rope_positions(string, lower);
       }},
      {"shape pose",
       [&] {
         world.set_shape_pose(floor, {{0.2f, -0.1f, 0}, about_z(5)});
       }},
      {"shape filter",
       [&] {
         world.set_filter(floor, {0, 0});
       }},
      {"body filter",
       [&] {
         world.set_filter(box, {0, 0});
       }},
      {"fluid filter",
       [&] {
         world.set_filter(water, {0, 0});
       }},
      {"cloth filter",
       [&] {
         world.set_filter(cloth, {0, 0});
       }},
      {"rope filter",
       [&] {
         world.set_filter(string, {0, 0});
       }},
      {"shape surface", [&] { world.set_surface(floor, slippery); }},
      {"body surface", [&] { world.set_surface(box, slippery); }},
  };
  for (const auto& [name, set] : setters) {
    SCOPED_TRACE(name);
    expect_way_back(world, set);
    set();
    World loaded = world.clone();
    EXPECT_EQ(state_of(loaded), state_of(world)) << "in a file";
    EXPECT_EQ(future_of(loaded, steps), future_of(world, steps)) << "in a file";
  }
}

MENISCUS_ON_EACH_DEVICE(SnapshotContentsTest);

}  // namespace
}  // namespace meniscus::tests
