// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of how the preview draws particles.
#include <gtest/gtest.h>
#include <meniscus/error.h>
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#include <stb/stb_image.h>
#include <unistd.h>

#include <cmath>
#include <limits>

#include "sdk/io/preview/preview.h"
#include "sdk/io/preview/raster.h"

namespace meniscus::io {
namespace {

struct Pixel {
  int r, g, b;
};

Pixel at(const Image& image, int x, int y) {
  const std::size_t i = 3 * (static_cast<std::size_t>(y) * image.width + x);
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

struct Particles {
  std::vector<Vec3> positions, velocities;
  std::vector<uint32_t> fluids;

  void add(Vec3 position, Vec3 velocity = {0, 0, 0}, uint32_t fluid = 0) {
    positions.push_back(position);
    velocities.push_back(velocity);
    fluids.push_back(fluid);
  }
  ParticleFrame frame() const {
    ParticleFrame frame;
    frame.positions = positions;
    frame.velocities = velocities;
    frame.fluids = fluids;
    return frame;
  }
};

/// A ball of radius 0.5 m around the origin.
Particles ball(float spacing, Vec3 velocity = {0, 0, 0}) {
  Particles particles;
  const int n = static_cast<int>(0.5f / spacing);
  for (int z = -n; z <= n; ++z) {
    for (int y = -n; y <= n; ++y) {
      for (int x = -n; x <= n; ++x) {
        const Vec3 p = spacing * Vec3{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
        if (length(p) <= 0.5f) particles.add(p, velocity);
      }
    }
  }
  return particles;
}

/// Small, and straight at the origin from the front.
PreviewScene small_scene() {
  PreviewScene scene;
  scene.fluid_colors = {{0.05f, 0.2f, 0.8f}, {0.8f, 0.1f, 0.05f}};
  scene.particle_spacing = 0.05f;
  scene.camera = SceneCamera{{0, 0, 4}, {0, 0, 0}, 35};
  scene.width = 320;
  scene.height = 180;
  return scene;
}

bool is_blue(Pixel p) {
  return p.b > p.r + 60;
}

TEST(Preview, ABallCoversADiscOfItsColour) {
  const Image image = render_preview(ball(0.05f).frame(), small_scene());
  ASSERT_EQ(image.width, 320);
  ASSERT_EQ(image.rgb.size(), 3u * 320 * 180);
  int blue = 0;
  for (int y = 0; y < 180; ++y) {
    for (int x = 0; x < 320; ++x) blue += is_blue(at(image, x, y));
  }
  // The silhouette of a sphere of radius r at distance d is a cone of sine r/d; the ball ends within a
  // spacing of 0.5 m.
  const double scale = 90 / std::tan(17.5 * M_PI / 180);
  const auto disc = [&](double r) { return M_PI * std::pow(scale * r / std::sqrt(16 - r * r), 2); };
  EXPECT_GT(blue, disc(0.45));
  EXPECT_LT(blue, disc(0.55));
  EXPECT_TRUE(is_blue(at(image, 160, 90)));
  EXPECT_FALSE(is_blue(at(image, 10, 90)));
}

TEST(Preview, EqualInputGivesEqualBytes) {
  const Particles particles = ball(0.05f);
  EXPECT_EQ(render_preview(particles.frame(), small_scene()).rgb,
            render_preview(particles.frame(), small_scene()).rgb);
}

TEST(Preview, FastFluidIsWhiter) {
  const Pixel still = at(render_preview(ball(0.05f).frame(), small_scene()), 160, 90);
  const Pixel fast = at(render_preview(ball(0.05f, {0, 0, 30}).frame(), small_scene()), 160, 90);
  EXPECT_GT(fast.r, still.r + 60);
}

TEST(Preview, SprayIsWhiterThanDeepWater) {
  const Particles particles = ball(0.05f, {0, 0, 3});
  const auto middle = [&](float density_error) {
    const std::vector<float> errors(particles.positions.size(), density_error);
    ParticleFrame frame = particles.frame();
    frame.density_errors = errors;
    return at(render_preview(frame, small_scene()), 160, 90);
  };
  const Pixel deep = middle(0), spray = middle(-0.8f);
  EXPECT_GT(spray.r, deep.r + 25);
  EXPECT_EQ(middle(std::numeric_limits<float>::quiet_NaN()).r, deep.r);
}

TEST(Preview, ParticlesTakeTheirFluidsColour) {
  Particles particles = ball(0.05f);
  for (std::size_t i = 0; i < particles.fluids.size(); ++i)
    particles.fluids[i] = particles.positions[i].x > 0.01f;
  const Image image = render_preview(particles.frame(), small_scene());
  EXPECT_TRUE(is_blue(at(image, 145, 90)));
  EXPECT_GT(at(image, 175, 90).r, at(image, 175, 90).b + 60);
}

TEST(Preview, NoParticlesShowTheBackdrop) {
  const Image image = render_preview({}, small_scene());
  const Pixel top = at(image, 5, 5), bottom = at(image, 300, 175);
  EXPECT_LT(top.r, bottom.r);
  EXPECT_EQ(at(image, 5, 90).g, at(image, 300, 90).g);
}

TEST(Preview, ParticlesThatAreNotFiniteAreLeftOut) {
  Particles particles = ball(0.05f);
  const Image clean = render_preview(particles.frame(), small_scene());
  particles.add({std::numeric_limits<float>::quiet_NaN(), 0, 0});
  particles.add({0, std::numeric_limits<float>::infinity(), 0});
  particles.add({1e30f, 1e30f, -1e30f});  // finite, but its square is not
  EXPECT_EQ(render_preview(particles.frame(), small_scene()).rgb, clean.rgb);
}

TEST(Preview, TheChosenViewHoldsEverything) {
  PreviewScene scene = small_scene();
  scene.camera.reset();
  Particles particles;
  for (const Vec3 p : {Vec3{-3, 0, 1}, Vec3{5, 0.2f, -1}, Vec3{1, 2, 0}}) particles.add(p);
  scene.particle_spacing = 0.4f;
  const Image image = render_preview(particles.frame(), scene);
  for (int x = 0; x < 320; ++x) EXPECT_FALSE(is_blue(at(image, x, 0)) || is_blue(at(image, x, 179))) << x;
  for (int y = 0; y < 180; ++y) EXPECT_FALSE(is_blue(at(image, 0, y)) || is_blue(at(image, 319, y))) << y;
  int blue = 0;
  for (int y = 0; y < 180; ++y) {
    for (int x = 0; x < 320; ++x) blue += is_blue(at(image, x, y));
  }
  EXPECT_GT(blue, 300);
}

TEST(Preview, EdgesOfAContainerHideBehindFluid) {
  PreviewScene scene = small_scene();
  const Image without = render_preview(ball(0.05f).frame(), scene);
  ShapeDef shape;
  shape.geometry = ContainerGeometry{{1.0f, 0.002f, 1.0f}, {{Face::y_low, std::nullopt}}};
  shape.pose.position = {0, 0,
                         -1.5f};  // behind the ball, but wider: its edges cross the picture at half height
  scene.shapes = {shape};
  const Image with = render_preview(ball(0.05f).frame(), scene);
  EXPECT_EQ(at(with, 160, 90).b, at(without, 160, 90).b);
  EXPECT_LT(at(with, 110, 90).b, at(without, 110, 90).b - 20);
}

/// Two boxes side by side.
PreviewScene two_boxes() {
  PreviewScene scene = small_scene();
  scene.bodies.resize(2);
  for (BodyDef& body : scene.bodies) body.geometry = BoxGeometry{{0.3f, 0.3f, 0.3f}};
  scene.bodies[0].pose.position = {-0.5f, 0, 0};
  scene.bodies[1].pose.position = {0.5f, 0, 0};
  return scene;
}

int difference(Pixel a, Pixel b) {
  return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
}

TEST(Preview, BodiesStandWhereTheirStatesSay) {
  const PreviewScene scene = two_boxes();
  const Pixel nothing = at(render_preview({}, small_scene()), 160, 90);
  const Image start = render_preview({}, scene);
  EXPECT_GT(difference(at(start, 125, 90), nothing), 60) << "without states they stand where they start";
  EXPECT_EQ(difference(at(start, 160, 90), nothing), 0);
  std::vector<BodyState> states(2);
  states[1].pose.position = {0, 50, 0};  // out of the picture
  const Image moved = render_preview({}, scene, states);
  EXPECT_GT(difference(at(moved, 160, 90), nothing), 60);
  EXPECT_EQ(difference(at(moved, 125, 90), nothing), 0);
}

TEST(Preview, BodiesDifferInColour) {
  const Image image = render_preview({}, two_boxes());
  EXPECT_GT(difference(at(image, 130, 90), at(image, 200, 90)), 60);
}

TEST(Preview, EveryPartOfACompoundIsDrawn) {
  PreviewScene scene = small_scene();
  scene.bodies.resize(1);
  CompoundGeometry pair;
  pair.parts.resize(2);
  pair.parts[0] = {HullGeometry{{{-0.2f, -0.3f, 0}, {0.2f, -0.3f, 0}, {0, 0.3f, 0}, {0, 0, 0.3f}}},
                   {{-0.5f, 0, 0}, {0, 0, 0, 1}}};
  pair.parts[1] = {CapsuleGeometry{0.2f, 0.2f}, {{0.5f, 0, 0}, {0, 0, 0, 1}}};
  scene.bodies[0].geometry = pair;
  const Image image = render_preview({}, scene);
  const Pixel nothing = at(render_preview({}, small_scene()), 160, 90);
  EXPECT_GT(difference(at(image, 125, 90), nothing), 40);
  EXPECT_GT(difference(at(image, 195, 90), nothing), 40);
  EXPECT_EQ(difference(at(image, 160, 90), nothing), 0);
}

TEST(Preview, OneStateTooFewIsRefused) {
  const std::vector<BodyState> states(1);
  try {
    render_preview({}, two_boxes(), states);
    FAIL() << "a body without a state was drawn";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    EXPECT_NE(std::string(error.what()).find("states has 1"), std::string::npos);
  }
}

TEST(Raster, FindsDepthAndNormalOfASphereFarAway) {
  // Small against its distance: where a careless intersection would be noise.
  const Camera camera(SceneCamera{{0, 0, 100}, {0, 0, 0}, 0.02f}, {0, 1, 0}, 100, 100);
  Drawing drawing;
  drawing.spheres.push_back({{0, 0, 0}, 0.01f, 3});
  Raster raster(camera);
  raster.draw(drawing);
  const std::size_t middle = raster.index(50, 50);
  EXPECT_EQ(raster.surface(middle), 3u);
  EXPECT_NEAR(raster.depth(middle), 99.99f, 2e-5f);
  EXPECT_LT(raster.normal(middle).z, -0.99f);
  EXPECT_EQ(raster.surface(raster.index(0, 0)), Raster::nothing);
}

TEST(Raster, TheNearerSurfaceWinsInAnyOrder) {
  const Camera camera(SceneCamera{{0, 0, 3}, {0, 0, 0}, 35}, {0, 1, 0}, 64, 64);
  const auto triangle = [](float z, uint32_t surface) {
    const Vec3 n{0, 0, 1};
    return Triangle{{Vec3{-9, -9, z}, Vec3{9, -9, z}, Vec3{0, 18, z}}, {n, n, n}, surface};
  };
  Drawing near_first, far_first;
  near_first.triangles = {triangle(1, 1), triangle(-1, 2)};
  far_first.triangles = {triangle(-1, 2), triangle(1, 1)};
  for (const Drawing& drawing : {near_first, far_first}) {
    Raster raster(camera);
    raster.draw(drawing);
    EXPECT_EQ(raster.surface(raster.index(32, 32)), 1u);
    EXPECT_NEAR(raster.depth(raster.index(10, 40)), 2, 1e-5);
  }
}

TEST(Raster, ATriangleThatReachesBehindTheEyeIsCut) {
  const Camera camera(SceneCamera{{0, 1, 0}, {0, 1, -1}, 60}, {0, 1, 0}, 64, 64);
  const Vec3 up{0, 1, 0};
  Drawing drawing;
  drawing.triangles.push_back({{Vec3{-50, 0, 40}, Vec3{50, 0, 40}, Vec3{0, 0, -60}}, {up, up, up}, 0});
  Raster raster(camera);
  raster.draw(drawing);
  // A row below the middle looks down at a known slope onto the plane a metre below.
  const float slope = -camera.view_ray(32, 60).y;
  EXPECT_NEAR(raster.depth(raster.index(32, 60)), 1 / slope, 1e-3);
  EXPECT_EQ(raster.surface(raster.index(32, 10)), Raster::nothing);
}

TEST(Png, IsReadBackAsItWasWritten) {
  Image image{3, 2, {}};
  for (int i = 0; i < 18; ++i) image.rgb.push_back(static_cast<uint8_t>(13 * i));
  const auto path =
      std::filesystem::temp_directory_path() / ("meniscus_png_" + std::to_string(getpid()) + ".png");
  write_png(path, image);
  int width = 0, height = 0, channels = 0;
  uint8_t* pixels = stbi_load(path.c_str(), &width, &height, &channels, 3);
  std::filesystem::remove(path);
  ASSERT_NE(pixels, nullptr);
  EXPECT_EQ(width, 3);
  EXPECT_EQ(height, 2);
  EXPECT_EQ(std::vector<uint8_t>(pixels, pixels + 18), image.rgb);
  stbi_image_free(pixels);
}

}  // namespace
}  // namespace meniscus::io
