// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Poses, filters and surfaces of what is there, set from outside.
#include "tests/unit/sdk/world/snapshot/cases.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr CollisionFilter nothing{0, 0};

class SetSolidsTest : public OnDevice {
 protected:
  /// A box of 0.2 m that lies on a table 1 m high, until it sleeps.
  struct Table {
    explicit Table(pbd::DeviceKind device) : world(world_def(device, 0.1f)) {
      world.create_shape(shape(PlaneGeometry{}, {0, 0, 0}));
      table = world.create_shape(shape(BoxGeometry{{0.5f, 0.1f, 0.5f}}, {0, 0.9f, 0}));
      box = world.create_body(body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0, 1.1f, 0}));
      for (int k = 0; k < 300 && world.body_state(box).awake; ++k) world.step(snapshot_step);
    }
    float height() const { return world.body_state(box).pose.position.y; }

    World world;
    ShapeId table;
    BodyId box;
  };
};

TEST_P(SetSolidsTest, AShapeThatMovesAwayLetsASleepingBodyFall) {
  Table t(GetParam());
  ASSERT_FALSE(t.world.body_state(t.box).awake);
  t.world.set_shape_pose(t.table, {{2, 0.9f, 0}});
  EXPECT_TRUE(t.world.body_state(t.box).awake);
  run(t.world, 60, snapshot_step);
  EXPECT_NEAR(t.height(), 0.1f, 0.01f);
}

/// Bodies that sleep wake where a shape arrives.
TEST_P(SetSolidsTest, AShapeThatArrivesPushesASleepingBodyOut) {
  Table t(GetParam());
  t.world.set_shape_pose(t.table, {{0, 0.95f, 0}});
  run(t.world, 30, snapshot_step);
  EXPECT_NEAR(t.height(), 1.15f, 0.01f);
}

TEST_P(SetSolidsTest, QueriesFindAShapeWhereItIs) {
  World world(world_def(GetParam(), 0.1f));
  const ShapeId id = world.create_shape(shape(BoxGeometry{{0.5f, 0.1f, 0.3f}}, {0, 1, 0}));
  world.step(snapshot_step);
  const Pose pose{{3, 2, 1}, about_z(30)};
  world.set_shape_pose(id, pose);
  World other(world_def(GetParam(), 0.1f));
  ShapeDef placed = shape(BoxGeometry{{0.5f, 0.1f, 0.3f}}, pose.position);
  placed.pose = pose;
  other.create_shape(placed);
  const std::vector<Vec3> points = lattice(5, 5, 5, 0.3f, {2.5f, 1.5f, 0.5f});
  EXPECT_EQ(world.solid_distances(points, 2), other.solid_distances(points, 2));
  const auto hit = world.cast_ray({3, 5, 1}, {3, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->shape, id);
  EXPECT_EQ(hit->point, other.cast_ray({3, 5, 1}, {3, 0, 1})->point);
  EXPECT_TRUE(world.overlap_ball({0, 1, 0}, 0.05f).shapes.empty());
}

/// What a shape that moved stops has the bits of what one that was made there stops.
TEST_P(SetSolidsTest, WaterMeetsAShapeWhereItIs) {
  const auto poured = [&](Vec3 first, Vec3 then) {
    World world(world_def(GetParam(), 0.05f));
    const ShapeId id = world.create_shape(shape(ContainerGeometry{{0.2f, 0.25f, 0.2f}, {}}, first));
    if (!(first == then)) {
      world.step(snapshot_step);
      world.set_shape_pose(id, {then, {0, 0, 0, 1}});
    }
    world.add_particles(world.create_fluid({}), lattice(6, 6, 6, 0.05f, {-0.15f, -0.2f, -0.15f}));
    run(world, 10, snapshot_step);
    return world.state_hash();
  };
  EXPECT_EQ(poured({5, 0, 0}, {0, 0.1f, 0}), poured({0, 0.1f, 0}, {0, 0.1f, 0}));
}

TEST_P(SetSolidsTest, AFilterLetsThingsThrough) {
  Table t(GetParam());
  t.world.set_filter(t.box, {2, 0xffffffffu});
  EXPECT_TRUE(t.world.body_state(t.box).awake);
  run(t.world, 10, snapshot_step);
  EXPECT_NEAR(t.height(), 1.1f, 0.01f) << "the table's mask has all groups";
  t.world.set_filter(t.table, {1, ~2u});
  run(t.world, 60, snapshot_step);
  EXPECT_NEAR(t.height(), 0.1f, 0.01f);
  EXPECT_TRUE(t.world.cast_ray({0, 2, 0}, {0, 0, 0}));
}

TEST_P(SetSolidsTest, AFilterStopsThingsAgain) {
  Table t(GetParam());
  t.world.set_filter(t.table, nothing);
  run(t.world, 5, snapshot_step);
  EXPECT_LT(t.height(), 1.1f);
  t.world.set_filter(t.table, {});
  t.world.set_body_pose(t.box, {{0, 1.3f, 0}});
  run(t.world, 60, snapshot_step);
  EXPECT_NEAR(t.height(), 1.1f, 0.01f);
}

TEST_P(SetSolidsTest, FiltersOfFluidsClothAndRopes) {
  World world(world_def(GetParam(), 0.1f));
  world.create_shape(shape(PlaneGeometry{}, {0, 0, 0}));
  const FluidId water = world.create_fluid({}), sand = world.create_granular({});
  world.add_particles(water, std::vector<Vec3>{{0, 0.05f, 0}});
  world.add_particles(sand, std::vector<Vec3>{{1, 0.05f, 0}});
  const ClothId cloth = world.create_cloth(sheet(0.3f, 0.3f, 4, 4, {0, 0.1f, 2}));
  const RopeId string = world.create_rope(rope({{2, 0.1f, 0}, {2.5f, 0.1f, 0}}, 4));
  run(world, 10, snapshot_step);
  const auto lowest = [&] {
    float y = std::min(world.positions()[0].y, world.positions()[1].y);
    for (const Vec3 p : world.cloth_positions(cloth)) y = std::min(y, p.y);
    for (const Vec3 p : world.rope_positions(string)) y = std::min(y, p.y);
    return y;
  };
  EXPECT_GT(lowest(), -0.01f);
  world.set_filter(water, nothing), world.set_filter(sand, nothing);
  world.set_filter(cloth, nothing), world.set_filter(string, nothing);
  run(world, 20, snapshot_step);
  for (const Vec3 p : world.positions()) EXPECT_LT(p.y, -0.2f);
  for (const Vec3 p : world.cloth_positions(cloth)) EXPECT_LT(p.y, -0.2f);
  for (const Vec3 p : world.rope_positions(string)) EXPECT_LT(p.y, -0.2f);
}

/// On a slope of 20° a box rests with μ = 1. Without friction it slides by ½ g sin 20° t².
TEST_P(SetSolidsTest, SurfacesOfBodies) {
  World world(world_def(GetParam(), 0.1f));
  SurfaceDef rough;
  rough.solid_friction = 1;
  ShapeDef slope = shape(BoxGeometry{{3, 0.1f, 1}}, {0, 0, 0});
  slope.pose.rotation = about_z(-20);
  slope.surface = rough;
  const ShapeId id = world.create_shape(slope);
  BodyDef box = body(BoxGeometry{{0.1f, 0.1f, 0.1f}});
  box.pose = {rotate(slope.pose.rotation, {-1, 0.2f, 0}), slope.pose.rotation};
  box.surface = rough;
  const BodyId slider = world.create_body(box);
  run(world, 30, snapshot_step);
  const Vec3 rest = world.body_state(slider).pose.position;
  EXPECT_NEAR(length(rest - box.pose.position), 0, 0.01f);
  SurfaceDef smooth;
  smooth.solid_friction = 0;
  world.set_surface(slider, smooth);
  const float time = 0.4f;
  for (int k = 0; k < 40; ++k) world.step(time / 40);
  const float expected = 0.5f * 9.81f * std::sin(20 * pi / 180) * time * time;
  EXPECT_NEAR(length(world.body_state(slider).pose.position - rest), expected, 0.03f * expected);
  world.set_surface(slider, rough);
  world.set_surface(id, smooth);
  const float before = length(world.body_state(slider).velocity);
  run(world, 10, snapshot_step);
  EXPECT_GT(length(world.body_state(slider).velocity), before) << "one smooth surface is enough";
}

/// A grain on a belt takes its velocity.
TEST_P(SetSolidsTest, SurfacesOfShapes) {
  World world(world_def(GetParam(), 0.1f));
  const ShapeId floor = world.create_shape(shape(PlaneGeometry{}, {0, 0, 0}));
  const FluidId sand = world.create_granular({});
  world.add_particles(sand, std::vector<Vec3>{{0, 0.05f, 0}});
  run(world, 10, snapshot_step);
  EXPECT_NEAR(world.velocities()[0].x, 0, 1e-4f);
  SurfaceDef belt;
  belt.friction = 1;
  belt.belt_velocity = {0.5f, 0, 0};
  world.set_surface(floor, belt);
  run(world, 20, snapshot_step);
  EXPECT_NEAR(world.velocities()[0].x, 0.5f, 0.01f);
}

TEST_P(SetSolidsTest, RefusesWhatASurfaceMayNotHave) {
  Table t(GetParam());
  const uint64_t before = t.world.state_hash();
  SurfaceDef wrong;
  wrong.friction = -1;
  expect_error(ErrorCode::invalid_argument, "SurfaceDef::friction",
               [&] { t.world.set_surface(t.table, wrong); });
  wrong = {};
  wrong.belt_velocity = {1, 0, 0};
  expect_error(ErrorCode::invalid_argument, "belt_velocity", [&] { t.world.set_surface(t.box, wrong); });
  EXPECT_EQ(t.world.state_hash(), before);
}

MENISCUS_ON_EACH_DEVICE(SetSolidsTest);

}  // namespace
}  // namespace meniscus::tests
