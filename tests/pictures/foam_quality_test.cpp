// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Pictures with foam are steady, and neither speckled nor stained.
#include <meniscus/scene.h>

#include "sdk/io/cloth_frame.h"
#include "tests/pictures/golden.h"
#include "tests/pictures/picture_metrics.h"

namespace meniscus::tests {
namespace {

class FoamQuality : public GoldenTest {
 protected:
  /// A pool that has come to rest in a tank, of 20 × 6 × 20 particles.
  static World pool() {
    World world(world_def(pbd::DeviceKind::cpu, 0.05f));
    world.create_shape(
        shape(ContainerGeometry{{0.5f, 0.4f, 0.5f}, {{Face::y_high, std::nullopt}}}, {0, 0.4f, 0}));
    world.add_fluid(block(world.create_fluid({}), {-0.5f, 0, -0.5f}, {0.5f, 0.3f, 0.5f}));
    for (int k = 0; k < 60; ++k) world.step(1.0f / 60);
    return world;
  }

  /// Foam that drifts over the pool by 2 cm/s, is made and fades away.
  static std::vector<DiffuseParticle> foam_at(int frame) {
    std::mt19937 random(5);
    const float time = static_cast<float>(frame) / 60;
    std::vector<DiffuseParticle> all;
    for (Vec3 p : lattice(80, 1, 80, 0.01f, {-0.4f, 0.3f, -0.4f})) {
      p = p + random_vector(random, 0.01f);
      const float life = 2 * static_cast<float>(random() % 1000) / 1000;
      if (std::sin(9 * p.x) + std::sin(7 * p.z) < 0) continue;
      all.push_back(
          {p + Vec3{0.02f * time, 0, 0}, {0.02f, 0, 0}, std::fmod(life + 2 - time, 2.0f), DiffuseKind::foam});
    }
    return all;
  }
};

TEST_F(FoamQuality, ARestingPoolDoesNotFlicker) {
  World world = pool();
  io::PreviewScene scene = on_ground({0.6f, 1.0f, 1.8f}, {0, 0.2f, 0}, 40);
  scene.width = 320;
  scene.height = 240;
  render::Renderer renderer(scene, {.world = &world});
  io::Image last;
  for (int frame = 0; frame < 4; ++frame) {
    const std::vector<DiffuseParticle> foam = foam_at(frame);
    const render::Moment moment{.ellipsoids = world.ellipsoids(),
                                .fluids = world.fluids(),
                                .velocities = world.velocities(),
                                .diffuse = foam};
    const io::Image image = renderer.draw(moment);
    EXPECT_EQ(renderer.draw(moment).rgb, image.rgb) << "the same state";
    if (frame > 0) {
      const Flicker flicker = flicker_of(last, image);
      EXPECT_LE(flicker.mean, 0.5);
      EXPECT_LE(flicker.highest_hundredth, 2);
      EXPECT_GT(flicker.mean, 0) << "the foam drifts";
    }
    last = image;
    world.step(1.0f / 60);
  }
}

}  // namespace
}  // namespace meniscus::tests
