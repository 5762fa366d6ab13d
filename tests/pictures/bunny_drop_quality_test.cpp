// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The picture of the sample bunny_drop at frame 150, compared with that of the renderer before foam was a
// volume.
#include <meniscus/scene.h>

#include "tests/pictures/golden.h"
#include "tests/pictures/picture_metrics.h"

namespace meniscus::tests {
namespace {

using BunnyDropQuality = GoldenTest;

/// Of commit 5e1ade5, on a CPU with Mesa's rasteriser.
constexpr PictureMetrics before{
    .noise = 10.0, .brightness = 170.2, .foam_cover = 0.0591, .dark_blue = 0.00458, .edge = 7.12};

TEST_F(BunnyDropQuality, HasFoamWithoutSpeckleAndStains) {
  Scene scene = read_scene(MENISCUS_SAMPLES_DIR "/scenes/bunny_drop.json");
  scene.world.device = DeviceChoice::cpu;
  BuiltScene built = build_scene(scene);
  World& world = built.world;
  render::Renderer renderer(io::preview_of(scene), {.world = &world});
  for (int frame = 0; frame < 150; ++frame) world.step(scene.frame_time);
  render::Moment moment{
      .ellipsoids = world.ellipsoids(), .fluids = world.fluids(), .velocities = world.velocities()};
  const io::Image bare = renderer.draw(moment);
  moment.diffuse = world.diffuse();
  const io::Image picture = renderer.draw(moment);
  const PictureMetrics now = metrics_of(picture, bare, renderer.fluid_normals());
  std::printf("noise %.2f, brightness %.2f, foam cover %.4f, dark blue %.5f, edge %.2f\n", now.noise,
              now.brightness, now.foam_cover, now.dark_blue, now.edge);
  EXPECT_LE(now.noise, 6.5);
  EXPECT_NEAR(now.brightness / before.brightness, 1, 0.1);
  EXPECT_NEAR(now.foam_cover / before.foam_cover, 1, 0.1);
  EXPECT_LE(now.dark_blue, 0.2 * before.dark_blue);
  EXPECT_GE(now.edge, 0.98 * before.edge) << "2 % for drivers that round differently";
}

}  // namespace
}  // namespace meniscus::tests
