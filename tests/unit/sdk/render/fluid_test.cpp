// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The optics of water in pictures.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/bench/harness/render_bench.h"
#include "tests/expect_error.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.05f;

class FluidPictureTest : public RenderTest {
 protected:
  /// From straight above, with a ground at y = 0.
  static io::PreviewScene above_ground() {
    io::PreviewScene scene = small_scene(spacing);
    scene.shapes = {shape(PlaneGeometry{})};
    scene.camera = SceneCamera{{0, 4, 0.01f}, {0, 0, 0}, 35};
    return scene;
  }

  /// A slab of this thickness that lies on the ground and fills the middle of the picture.
  static Water slab(float thickness) {
    return Water(points_where(spacing, {0.8f, 1, 0.8f}, [&](Vec3 p) { return p.y > 0 && p.y < thickness; }),
                 spacing);
  }
};

TEST_F(FluidPictureTest, ThicknessIsWhatTheSlabMeasures) {
  for (float thickness : {0.1f, 0.4f}) {
    const Water water = slab(thickness);
    const io::PreviewScene scene = above_ground();
    render::Renderer renderer(scene, water.moment());
    renderer.draw(water.moment());
    const std::vector<float> metres = renderer.fluid_thickness();
    ASSERT_EQ(metres.size(), 80u * 60u);
    double sum = 0;
    for (int y = 20; y < 40; ++y) {
      for (int x = 30; x < 50; ++x) sum += metres[static_cast<std::size_t>(y) * 80 + x];
    }
    EXPECT_NEAR(sum / 400 / thickness, 1, 0.04) << thickness;
    EXPECT_EQ(metres[0], 0);
  }
}

TEST_F(FluidPictureTest, WaterBehindASolidDoesNotCount) {
  io::PreviewScene scene = above_ground();
  scene.shapes.push_back(shape(BoxGeometry{{0.3f, 0.05f, 0.3f}}, {0, 0.8f, 0}));
  const Water water = slab(0.4f);
  render::Renderer renderer(scene, water.moment());
  renderer.draw(water.moment());
  EXPECT_EQ(renderer.fluid_thickness()[30 * 80 + 40], 0);
  EXPECT_GT(renderer.fluid_thickness()[30 * 80 + 25], 0.3f);
}

TEST_F(FluidPictureTest, DeeperWaterTakesMoreRedAndHasItsFluidsColour) {
  const io::PreviewScene scene = above_ground();
  const Pixel ground = at(draw(scene), 80, 60);
  const Pixel shallow = at(draw(scene, slab(0.1f).moment()), 80, 60);
  const Pixel deep = at(draw(scene, slab(0.8f).moment()), 80, 60);
  EXPECT_LT(shallow.r, ground.r);
  EXPECT_LT(deep.r, shallow.r - 30);
  EXPECT_GT(deep.b, deep.g);
  EXPECT_GT(deep.g, deep.r);

  io::PreviewScene red = scene;
  red.fluid_colors = {{0.8f, 0.1f, 0.1f}};
  const Pixel wine = at(draw(red, slab(0.8f).moment()), 80, 60);
  EXPECT_GT(wine.r, wine.g + 40);
}

TEST_F(FluidPictureTest, FluidsKeepTheirColours) {
  io::PreviewScene scene = above_ground();
  scene.fluid_colors = {{0.1f, 0.3f, 0.8f}, {0.8f, 0.2f, 0.1f}};
  const Water water = slab(0.5f);
  render::Moment moment = water.moment();
  std::vector<uint32_t> fluids;
  for (const Ellipsoid& e : moment.ellipsoids) fluids.push_back(e.centre.x > 0);
  moment.fluids = fluids;
  const io::Image image = draw(scene, moment);
  EXPECT_GT(at(image, 60, 60).b, at(image, 60, 60).r + 30);
  EXPECT_GT(at(image, 100, 60).r, at(image, 100, 60).b + 30);
}

TEST_F(FluidPictureTest, ManyFluidsKeepTheirColours) {
  io::PreviewScene scene = above_ground();
  scene.fluid_colors.assign(1024, {0.1f, 0.3f, 0.8f});
  scene.fluid_colors.back() = {0.8f, 0.2f, 0.1f};
  const Water water = slab(0.5f);
  render::Moment moment = water.moment();
  const std::vector<uint32_t> fluids(moment.ellipsoids.size(), 1023);
  moment.fluids = fluids;
  const Pixel red = at(draw(scene, moment), 80, 60);
  EXPECT_GT(red.r, red.b + 30);
  scene.fluid_colors.push_back({0, 0, 0});
  expect_error(ErrorCode::invalid_argument, "the scene has 1025 fluids", [&] { draw(scene, moment); });
}

/// The upper half of a heap is sand: neither light nor sight passes it.
TEST_F(FluidPictureTest, GrainsHideWhatIsBehindThem) {
  io::PreviewScene scene = above_ground();
  scene.fluid_colors = {{0.1f, 0.3f, 0.8f}, {0.5f, 0.35f, 0.15f}};
  const Water water = slab(0.5f);
  render::Moment moment = water.moment();
  std::vector<uint32_t> fluids;
  for (const Ellipsoid& e : moment.ellipsoids) fluids.push_back(e.centre.y > 0.3f && e.centre.x > 0);
  moment.fluids = fluids;
  const auto drawn = [&](std::size_t first_granular) {
    scene.first_granular = first_granular;
    render::Renderer renderer(scene, moment);
    const io::Image image = renderer.draw(moment);
    return std::pair(image, renderer.fluid_thickness());
  };
  const auto [dyed, dyed_metres] = drawn(2);
  const auto [sandy, metres] = drawn(1);
  EXPECT_EQ(difference(at(sandy, 60, 60), at(dyed, 60, 60)), 0) << "where there is water alone";
  Pixel mean{0, 0, 0};
  for (int x = 90; x < 110; ++x) {
    const Pixel p = at(sandy, x, 60);
    mean = {mean.r + p.r / 20, mean.g + p.g / 20, mean.b + p.b / 20};
  }
  EXPECT_GT(mean.r, mean.b + 30);
  EXPECT_GT(dyed_metres[30 * 80 + 50], 0.4f);
  EXPECT_LT(metres[30 * 80 + 50], 0.05f);
}

TEST_F(FluidPictureTest, WaterCastsAColouredShadow) {
  io::PreviewScene scene = above_ground();
  const Water drop(points_where(spacing, {0.4f, 1.0f, 0.4f},
                                [](Vec3 p) {
                                  return length(p - Vec3{0, 0.6f, 0}) < 0.3f;
                                }),
                   spacing);
  scene.camera = SceneCamera{{0, 3.5f, 2.5f}, {0.3f, 0, 0}, 35};
  const io::Image lit = draw(scene);
  render::Renderer renderer(scene, drop.moment());
  const io::Image shaded = renderer.draw(drop.moment());
  const auto water = renderer.fluid_normals();
  int dyed = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      if (water[static_cast<std::size_t>(y) * 160 + x][3] > 0) continue;
      const Pixel before = at(lit, x, y), now = at(shaded, x, y);
      dyed += now.r < before.r - 15 && now.b - now.r > before.b - before.r + 8;
    }
  }
  EXPECT_GT(dyed, 200);
}

TEST_F(FluidPictureTest, WaterBendsTheLight) {
  // A slope of clear water at 45° above a brown rod, half a metre deep.
  io::PreviewScene scene = above_ground();
  scene.fluid_colors = {{0.98f, 0.98f, 0.98f}};
  scene.camera->field_of_view = 15;
  scene.bodies.resize(1);
  scene.bodies[0].geometry = BoxGeometry{{0.03f, 0.02f, 2}};
  const auto rod = [](const io::Image& image) {
    double sum = 0, columns = 0;
    for (int x = 30; x < 130; ++x) {
      const Pixel p = at(image, x, 60);
      if (p.r < p.b + 30) continue;
      sum += x;
      ++columns;
    }
    return sum / columns;
  };
  EXPECT_NEAR(rod(draw(scene)), 79.5, 1);
  const Water water(
      points_where(spacing, {0.5f, 1.1f, 0.5f}, [](Vec3 p) { return p.y > 0.05f && p.y < 0.5f + p.x; }),
      spacing);
  // Snell: the ray leaves the vertical by 45° − asin(sin 45°/1.333) = 12.9°, towards higher water.
  const double shift = 0.5 * std::tan(12.9 * 3.14159 / 180) * 120 / (2 * 3.5 * std::tan(7.5 * 3.14159 / 180));
  EXPECT_NEAR(std::abs(rod(draw(scene, water.moment())) - 79.5), shift, 0.4 * shift);
}

TEST_F(FluidPictureTest, LowAnglesMirrorTheSky) {
  io::PreviewScene scene = above_ground();
  scene.fluid_colors = {{0.02f, 0.02f, 0.02f}};  // black but for what it mirrors
  const Water water = slab(0.5f);
  const auto brightness = [&](Vec3 eye) {
    scene.camera = SceneCamera{eye, {0, 0.5f, 0}, 20};
    return sum(at(draw(scene, water.moment()), 80, 60));
  };
  EXPECT_GT(brightness({0, 0.9f, 3}), 1.6 * brightness({0, 4, 0.5f}));
}

TEST_F(FluidPictureTest, ParticlesThatAreNotFiniteAreLeftOut) {
  const Water water = slab(0.2f);
  const io::PreviewScene scene = above_ground();
  const io::Image clean = draw(scene, water.moment());
  std::vector<Ellipsoid> ellipsoids(water.moment().ellipsoids.begin(), water.moment().ellipsoids.end());
  std::vector<uint32_t> fluids(water.moment().fluids.begin(), water.moment().fluids.end());
  Ellipsoid bad = ellipsoids.front();
  bad.centre.x = std::nanf("");
  ellipsoids.push_back(bad);
  fluids.push_back(0);
  EXPECT_EQ(draw(scene, {.ellipsoids = ellipsoids, .fluids = fluids}).rgb, clean.rgb);
}

/// Of those that cover few tiles of the picture, and of one that covers most.
TEST_F(FluidPictureTest, ABallOfAnySizeIsDrawnWhole) {
  for (const float radius : {0.02f, 0.1f, 0.8f}) {
    io::PreviewScene scene = small_scene(radius);
    scene.width = 640;
    scene.height = 480;
    scene.shapes = {shape(PlaneGeometry{}, {0, -50, 0})};
    const Ellipsoid ball{{0, 0, 0}, {radius, radius, radius}, {0, 0, 0, 1}};
    const uint32_t fluid = 0;
    const render::Moment moment{.ellipsoids = {&ball, 1}, .fluids = {&fluid, 1}};
    render::RenderSettings settings;
    settings.filter = render::SurfaceFilter::none;
    render::Renderer renderer(scene, moment, settings);
    renderer.draw(moment);
    const auto normals = renderer.fluid_normals();
    const auto seen = std::count_if(normals.begin(), normals.end(), [](const auto& n) { return n[3] > 0; });
    // The cone of sight that touches it, in a picture that is 35° high.
    const double wide =
        240 * radius / std::sqrt(9 - radius * radius) / std::tan(17.5 * std::numbers::pi / 180);
    EXPECT_NEAR(seen / (std::numbers::pi * wide * wide), 1, 1 / wide) << radius;
    EXPECT_NEAR(normals[240 * 640 + 320][3], 3 - radius, 1e-3f) << radius;
  }
}

TEST_F(FluidPictureTest, MoreParticlesThanBuffersHoldAreAnError) {
  GLint64 bytes = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  if (bytes > 1 << 28) GTEST_SKIP() << "this OpenGL's buffers hold " << bytes << " bytes";
  render::Renderer renderer(small_scene(), {});
  const std::vector<Ellipsoid> ellipsoids(static_cast<std::size_t>(bytes) / sizeof(Ellipsoid) + 1);
  const std::vector<uint32_t> fluids(ellipsoids.size());
  expect_error(ErrorCode::capacity, std::to_string(ellipsoids.size()),
               [&] { renderer.load({.ellipsoids = ellipsoids, .fluids = fluids}); });
}

}  // namespace
}  // namespace meniscus::tests
