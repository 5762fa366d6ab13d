// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Water makes room for a solid that is placed into it, without high speeds.
#include <gtest/gtest.h>

#include <optional>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class PlacedSolids : public OnDevice {
 protected:
  PlacedSolids() {
    WorldDef def = world_def(GetParam(), 0.04f);
    def.substeps = 4;
    world.emplace(def);
    world->create_shape(tank({-0.4f, 0, -0.4f}, {0.4f, 1.5f, 0.4f}));
    world->add_fluid(block(world->create_fluid({}), {-0.4f, 0, -0.4f}, {0.4f, 0.5f, 0.4f}));
    for (int k = 0; k < 30; ++k) world->step(1 / 60.0f);
  }

  static BodyDef box(BodyMotion motion) {
    BodyDef def;
    def.geometry = geometry;
    def.motion = motion;
    def.pose.position = centre;
    return def;
  }

  /// Held where it is, half a second later nothing is inside.
  void expect_calm(const char* what, bool stays) {
    float fastest = 0;
    for (int k = 0; k < 30; ++k) {
      world->step(1 / 60.0f);
      for (Vec3 v : world->velocities()) fastest = std::max(fastest, length(v));
    }
    // Taken out within a substep, the innermost would have 30 m/s and more.
    EXPECT_LT(fastest, 9) << what;
    if (!stays) return;
    int inside = 0;
    for (Vec3 x : world->positions()) inside += max_component(abs(x - centre)) < geometry.half_extents.x;
    EXPECT_EQ(inside, 0) << what;
  }

  static constexpr BoxGeometry geometry{{0.15f, 0.15f, 0.15f}};
  static constexpr Vec3 centre{0, 0.25f, 0};
  std::optional<World> world;
};
MENISCUS_ON_EACH_DEVICE(PlacedSolids);

TEST_P(PlacedSolids, AShape) {
  world->create_shape(shape(geometry, centre));
  expect_calm("a shape", true);
}

TEST_P(PlacedSolids, AFloatingBody) {
  world->create_body(box(BodyMotion::dynamic));
  expect_calm("a body", false);
}

TEST_P(PlacedSolids, ABodyThatIsMovedThere) {
  BodyDef def = box(BodyMotion::kinematic);
  def.pose.position = {0, 1.2f, 0};
  const BodyId body = world->create_body(def);
  world->step(1 / 60.0f);
  world->set_body_pose(body, {centre, {0, 0, 0, 1}});
  expect_calm("a body that is moved there", true);
}

/// The fastest that blocks of water in a box become.
class PlacedWater : public OnDevice {
 protected:
  static float fastest(World& world) {
    float speed = 0;
    for (int k = 0; k < 5; ++k) speed = std::max(speed, world.step(1 / 60.0f).max_speed);
    return speed;
  }
  static WorldDef def() {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.substeps = 8;
    return def;
  }
  World world_{def()};
  FluidDef water_;
  std::vector<Vec3> block_ = lattice(4, 4, 4, 0.05f, {-0.025f, 0.225f, -0.025f});
};
MENISCUS_ON_EACH_DEVICE(PlacedWater);

TEST_P(PlacedWater, IsNotThrownOutOfASolid) {
  const FluidId id = world_.create_fluid(water_);
  world_.create_shape(shape(BoxGeometry{}));
  world_.step(0.001f);
  world_.add_particles(id, block_);
  EXPECT_LT(fastest(world_), 12);
}

TEST_P(PlacedWater, IsNotThrownOutOfWhatBecomesSolidToIt) {
  water_.filter.mask = 1;
  const FluidId id = world_.create_fluid(water_);
  ShapeDef box = shape(BoxGeometry{});
  box.filter.groups = 2;
  world_.create_shape(box);
  world_.add_particles(id, block_);
  world_.step(0.001f);
  water_.filter.mask = 3;
  world_.set_fluid(id, water_);
  EXPECT_LT(fastest(world_), 12);
}

}  // namespace
}  // namespace meniscus::tests
