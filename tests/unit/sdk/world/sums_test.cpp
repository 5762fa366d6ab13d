// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// With fixed sums a motion has the same bits whatever else is in the world.
#include <gtest/gtest.h>

#include <numeric>

#include "pbd/math/hash.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

WorldDef fixed_def(pbd::DeviceKind device) {
  WorldDef def = world_def(device, 0.05f);
  def.sums = Sums::fixed;
  def.iterations = 4;
  def.density.artificial_pressure.strength = 0.05f;
  return def;
}

/// A vessel on a plane, open above, with two fluids that fall apart, an obstacle and a floating box.
struct Scene {
  explicit Scene(const WorldDef& def) : world(def) {
    FluidDef first, second;
    first.vorticity_confinement = 0.2f;
    first.surface_tension = 0.07f;
    second.rest_density = 500;
    water = world.create_fluid(first);
    const FluidId oil = world.create_fluid(second);
    ShapeDef floor = shape(PlaneGeometry{});
    floor.surface.friction = 0.3f;
    world.create_shape(floor);
    for (const float side : {-1.0f, 1.0f}) {
      world.create_shape(shape(BoxGeometry{{0.1f, 0.6f, 0.6f}}, {0.5f + 0.6f * side, 0.6f, 0.25f}));
      world.create_shape(shape(BoxGeometry{{0.7f, 0.6f, 0.1f}}, {0.5f, 0.6f, 0.25f + 0.35f * side}));
    }
    world.create_shape(shape(SphereGeometry{0.1f}, {0.7f, 0.1f, 0.25f}));
    world.add_fluid(block(water, {0, 0, 0}, {0.4f, 0.5f, 0.5f}));
    world.add_fluid(block(oil, {0.4f, 0, 0}, {0.7f, 0.3f, 0.5f}));
    box = world.create_body(validation::body(BoxGeometry{{0.1f, 0.05f, 0.1f}}, {0.2f, 0.6f, 0.25f}, 300));
    own = world.particle_count();
  }
  /// Adds fluid that nothing here meets.
  void add_far(Vec3 at, Vec3 size) { world.add_fluid(block(water, at, at + size)); }

  /// Of what was here first.
  uint64_t hash() const {
    uint64_t sum = 0;
    for (uint32_t k = 0; k < own; ++k)
      sum += pbd::element_hash(k, world.positions()[k], world.velocities()[k]);
    const BodyState state = world.body_state(box);
    return sum + pbd::element_hash(own, state.pose.position, state.velocity);
  }

  World world;
  FluidId water{};
  BodyId box{};
  size_t own = 0;
};

class SumsTest : public OnDevice {
 protected:
  uint64_t alone() {
    Scene scene(fixed_def(GetParam()));
    run(scene.world, steps, dt);
    return scene.hash();
  }
  /// More particles than any choice of threads on a GPU looks for.
  Vec3 crowd() const {
    return GetParam() == pbd::DeviceKind::cuda ? Vec3{2, 2, 2.5f} : Vec3{0.6f, 0.6f, 0.5f};
  }

  static constexpr int steps = 25;
  static constexpr float dt = 0.01f;
};

TEST_P(SumsTest, FarFluidChangesNoBit) {
  Scene scene(fixed_def(GetParam()));
  scene.add_far({12, 0.5f, 3}, crowd());
  scene.add_far({-9, 3, -7}, {0.2f, 0.2f, 0.2f});
  ASSERT_GT(scene.world.particle_count(), scene.own + 1000);
  run(scene.world, steps, dt);
  EXPECT_EQ(scene.hash(), alone());
}

TEST_P(SumsTest, NorDoesAnotherExtent) {
  Scene scene(fixed_def(GetParam()));
  scene.add_far({500, 2, 300}, {0.05f, 0.05f, 0.05f});
  scene.add_far({-800, 40, 3}, {0.05f, 0.05f, 0.05f});
  run(scene.world, steps, dt);
  EXPECT_EQ(scene.hash(), alone());
}

TEST_P(SumsTest, NorItsRemoval) {
  Scene scene(fixed_def(GetParam()));
  scene.add_far({12, 0.5f, 3}, crowd());
  run(scene.world, 10, dt);
  std::vector<ParticleId> far(scene.world.ids().begin() + static_cast<std::ptrdiff_t>(scene.own),
                              scene.world.ids().end());
  scene.world.remove_particles(far);
  run(scene.world, steps - 10, dt);
  EXPECT_EQ(scene.world.particle_count(), scene.own);
  EXPECT_EQ(scene.hash(), alone());
}

TEST_P(SumsTest, AreNotThoseOfTheDefault) {
  WorldDef def = fixed_def(GetParam());
  def.sums = Sums::automatic;
  Scene scene(def);
  scene.add_far({-800, 60, 3}, {0.05f, 0.05f, 0.05f});
  run(scene.world, steps, dt);
  EXPECT_NE(scene.hash(), alone()) << "the scenes above would not notice a difference";
}

TEST_P(SumsTest, StayAsTheWorldWasMade) {
  World world(fixed_def(GetParam()));
  WorldDef def = fixed_def(GetParam());
  def.sums = Sums::automatic;
  EXPECT_THROW(world.set_def(def), Error);
}

MENISCUS_ON_EACH_DEVICE(SumsTest);

}  // namespace
}  // namespace meniscus::tests
