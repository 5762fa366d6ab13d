// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Particles that the simulating GPU passes to OpenGL without a copy through the host.
#include "tests/bench/harness/render_bench.h"
#include "tests/expect_error.h"
#include "tests/pictures/picture_difference.h"

namespace meniscus::tests {
namespace {

class SharedPictures : public RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    if (!pbd::cuda_status().usable) GTEST_SKIP() << pbd::cuda_status().reason;
  }

  static World falling() {
    World world(world_def(pbd::DeviceKind::cuda, 0.05f));
    world.create_shape(shape(PlaneGeometry{}, {0, -0.5f, 0}));
    world.add_fluid(block(world.create_fluid({}), {-0.5f, -0.5f, -0.3f}, {0.1f, 0.4f, 0.3f}));
    for (int k = 0; k < 20; ++k) world.step(0.01f);
    return world;
  }
};

TEST_F(SharedPictures, LookAsThoseByWayOfTheHost) {
  const World world = falling();
  const render::Moment shared{.world = &world},
      copied{.ellipsoids = world.ellipsoids(), .fluids = world.fluids(), .velocities = world.velocities()};
  render::Renderer renderer(small_scene(), shared);
  const io::Image a = renderer.draw(shared), b = renderer.draw(copied), again = renderer.draw(shared);
  EXPECT_TRUE(difference_of(a, b).acceptable());
  EXPECT_EQ(a.rgb, again.rgb);
}

TEST_F(SharedPictures, FollowTheWorld) {
  World world = falling();
  render::Renderer renderer(small_scene(), {.world = &world});
  const io::Image before = renderer.draw({.world = &world});
  world.add_fluid(block(world.create_fluid({}), {0.2f, -0.5f, -0.3f},
                        {0.5f, 0.4f, 0.3f}));  // more than there was room for
  world.step(0.01f);
  EXPECT_FALSE(difference_of(before, renderer.draw({.world = &world})).acceptable());
}

TEST_F(SharedPictures, NeedBuffersWithRoom) {
  const World world = falling();
  const std::size_t count = world.particle_count();
  render::DataBuffer ellipsoids, fluids, few_fluids, few_velocities;
  ellipsoids.resize(sizeof(Ellipsoid) * count);
  fluids.resize(sizeof(uint32_t) * count);
  few_fluids.resize(sizeof(uint32_t) * (count - 1));
  few_velocities.resize(sizeof(Vec3) * (count - 1));
  GlParticles particles(ellipsoids.name(), few_fluids.name()),
      moving(ellipsoids.name(), fluids.name(), few_velocities.name());
  for (GlParticles* buffers : {&particles, &moving})
    expect_error(ErrorCode::invalid_argument, "GlParticles", [&] { world.write_particles(*buffers); });
  const World other(world_def(pbd::DeviceKind::cpu, 0.05f));
  expect_error(ErrorCode::invalid_argument, "World::device", [&] { other.write_particles(particles); });
}

}  // namespace
}  // namespace meniscus::tests
