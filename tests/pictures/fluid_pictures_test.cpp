// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The fluid's passes one by one, and what light does in it.
#include <algorithm>

#include "tests/pictures/golden.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.05f;

uint8_t byte_of(float value) {
  return static_cast<uint8_t>(std::clamp(255 * value, 0.0f, 255.0f) + 0.5f);
}

class FluidPictures : public GoldenTest {
 protected:
  /// A pool, a ball above it that hides some of its surface, and lone drops.
  static Water splash() {
    std::vector<Vec3> points = points_where(spacing, {0.9f, 0.9f, 0.9f}, [](Vec3 p) {
      return p.y < -0.3f + 0.1f * std::sin(7 * p.x) || length(p - Vec3{0.1f, 0.25f, 0.1f}) < 0.3f;
    });
    for (int i = 0; i < 12; ++i) {
      const float t = static_cast<float>(i);
      points.push_back({0.13f * t - 0.75f, 0.1f + 0.3f * std::sin(2.1f * t), 0.8f});
    }
    return Water(points, spacing);
  }
  static io::PreviewScene around_splash() {
    io::PreviewScene scene = small_scene(spacing);
    scene.camera = SceneCamera{{0.4f, 1.2f, 2.8f}, {0, -0.1f, 0}, 35};
    return scene;
  }
  static std::unique_ptr<render::Renderer> drawn(const io::PreviewScene& scene, const Water& water,
                                                 render::SurfaceFilter filter, bool anisotropic = true) {
    render::RenderSettings settings;
    settings.filter = filter;
    settings.anisotropic = anisotropic;
    auto renderer = std::make_unique<render::Renderer>(scene, water.moment(), settings);
    renderer->draw(water.moment());
    return renderer;
  }

  /// Normals as colours, as a normal map has them.
  static void expect_normals(const std::string& name, render::SurfaceFilter filter, bool anisotropic = true) {
    const io::PreviewScene scene = around_splash();
    io::Image image{scene.width, scene.height, {}};
    for (const auto& n : drawn(scene, splash(), filter, anisotropic)->fluid_normals()) {
      for (int k = 0; k < 3; ++k) image.rgb.push_back(n[3] > 0 ? byte_of(0.5f + 0.5f * n[k]) : 0);
    }
    expect_picture(name, image);
  }

  /// On the ground, `height(x)` high.
  template <class Height>
  static Water on_floor(const Height& height) {
    return Water(points_where(spacing, {0.8f, 1, 0.5f}, [&](Vec3 p) { return p.y > 0 && p.y < height(p.x); }),
                 spacing);
  }
};

TEST_F(FluidPictures, DepthOfEllipsoids) {
  const io::PreviewScene scene = around_splash();
  io::Image image{scene.width, scene.height, {}};
  for (const auto& n : drawn(scene, splash(), render::SurfaceFilter::none)->fluid_normals()) {
    const float near = n[3] > 0 ? (4.2f - n[3]) / 2.4f : 0;
    image.rgb.insert(image.rgb.end(), 3, byte_of(near));
  }
  expect_picture("ellipsoid_depth", image);
}

TEST_F(FluidPictures, NormalsOfEllipsoids) {
  expect_normals("ellipsoid_normals", render::SurfaceFilter::none);
}

TEST_F(FluidPictures, NormalsOfBalls) {
  expect_normals("ball_normals", render::SurfaceFilter::none, false);
}

TEST_F(FluidPictures, NarrowRangeFilter) {
  expect_normals("narrow_range", render::SurfaceFilter::narrow_range);
}

TEST_F(FluidPictures, BilateralFilter) {
  expect_normals("bilateral", render::SurfaceFilter::bilateral);
}

TEST_F(FluidPictures, CurvatureFlow) {
  expect_normals("curvature_flow", render::SurfaceFilter::curvature_flow);
}

TEST_F(FluidPictures, Thickness) {
  io::PreviewScene scene = around_splash();
  scene.shapes = {shape(SphereGeometry{0.15f}, {-0.5f, 0, 0.8f})};  // hides what is behind it
  io::Image image{80, 60, {}};
  for (const float metres : drawn(scene, splash(), render::SurfaceFilter::narrow_range)->fluid_thickness())
    image.rgb.insert(image.rgb.end(), 3, byte_of(metres / 2));
  expect_picture("thickness", image);
}

TEST_F(FluidPictures, ColouredShadows) {
  io::PreviewScene scene = on_ground({0.4f, 2.6f, 2}, {0.3f, 0.1f, 0});
  scene.fluid_colors = {{0.1f, 0.35f, 0.8f}, {0.8f, 0.2f, 0.1f}};
  const Water drops(
      points_where(
          spacing, {0.8f, 0.9f, 0.3f},
          [](Vec3 p) {
            return length(p - Vec3{-0.5f, 0.5f, 0}) < 0.25f || length(p - Vec3{0.3f, 0.5f, 0}) < 0.25f;
          }),
      spacing);
  render::Moment moment = drops.moment();
  std::vector<uint32_t> fluids;
  for (const Ellipsoid& e : moment.ellipsoids) fluids.push_back(e.centre.x > -0.1f);
  moment.fluids = fluids;
  expect_drawn("coloured_shadows", scene, moment);
}

/// Of a block in which nothing has moved yet: no pattern of its layers on the side that the sun is on.
TEST_F(FluidPictures, SunlitSide) {
  const io::PreviewScene scene = on_ground({-1.4f, 0.7f, 1.6f}, {0, 0.4f, 0});
  const Water block(lattice(12, 16, 12, spacing, {-0.3f, 0, -0.3f}), spacing);
  expect_drawn("sunlit_side", scene, block.moment());
}

/// Clear water in a wedge over the ground's tiles and a rod.
TEST_F(FluidPictures, Refraction) {
  io::PreviewScene scene = on_ground({0, 2.6f, 0.8f}, {0, 0, 0});
  scene.fluid_colors = {{0.98f, 0.98f, 0.98f}};
  scene.bodies.resize(1);
  scene.bodies[0].geometry = BoxGeometry{{0.04f, 0.04f, 0.7f}};
  expect_drawn("refraction", scene, on_floor([](float x) { return 0.3f + 0.3f * x; }).moment());
}

/// From nothing to half a metre deep.
TEST_F(FluidPictures, Absorption) {
  const io::PreviewScene scene = on_ground({0, 2.6f, 0.8f}, {0, 0, 0});
  expect_drawn("absorption", scene, on_floor([](float x) { return 0.35f + 0.35f * x; }).moment());
}

/// Blocks of the liquids on the ground, 4 m wide: clear, sea and pool behind, and milk, honey and oil before
/// them.
TEST_F(FluidPictures, Liquids) {
  constexpr float coarse = 0.5f;
  io::PreviewScene scene = on_ground({0, 13, 21}, {0, 0.5f, 0.5f});
  scene.particle_spacing = coarse;
  std::vector<Vec3> points;
  for (int k = 0; k < 6; ++k) {
    scene.media.push_back(io::medium_of(static_cast<Liquid>(k)));
    const Vec3 corner{5.5f * static_cast<float>(k % 3) - 7.5f, 0, k < 3 ? -4.5f : 1};
    const std::vector<Vec3> block = lattice(8, 5, 8, coarse, corner);
    points.insert(points.end(), block.begin(), block.end());
  }
  const Water blocks(points, coarse);
  render::Moment moment = blocks.moment();
  std::vector<uint32_t> fluids;
  for (const Ellipsoid& e : moment.ellipsoids)
    fluids.push_back((e.centre.x > -2.75f) + (e.centre.x > 2.75f) + (e.centre.z > 0.25f ? 3u : 0u));
  moment.fluids = fluids;
  expect_drawn("liquids", scene, moment);
}

/// Waves gather the light of the sun on the ground beneath them.
TEST_F(FluidPictures, Caustics) {
  constexpr float fine = 0.03f;
  io::PreviewScene scene = on_ground({0, 2.3f, 1.6f}, {0, 0, 0.05f}, 35);
  scene.particle_spacing = fine;
  scene.fluid_colors = {{0.75f, 0.9f, 0.95f}};
  const Water waves(
      points_where(fine, {0.9f, 0.6f, 0.6f},
                   [](Vec3 p) { return p.y > 0 && p.y < 0.4f + 0.03f * std::sin(14 * p.x + 5 * p.z); }),
      fine);
  const render::Moment moment = waves.moment();
  expect_picture("caustics", render::Renderer(scene, moment, {.caustics = true}).draw(moment));
}

/// Black fluid shows nothing but what it mirrors: sky, ground and sun.
TEST_F(FluidPictures, Reflection) {
  io::PreviewScene scene = on_ground({0.9f, 0.75f, 1.9f}, {-0.05f, 0.3f, 0});
  scene.fluid_colors = {{0.02f, 0.02f, 0.02f}};
  const Water hills = on_floor([](float x) { return 0.4f + 0.1f * std::cos(6 * x); });
  expect_drawn("reflection", scene, hills.moment());
}

/// A heap of sand, half of it in water.
TEST_F(FluidPictures, Grains) {
  io::PreviewScene scene = on_ground({0.3f, 1.3f, 2.3f}, {0, 0.15f, 0});
  scene.fluid_colors.push_back(GranularDef{}.color);
  scene.fluid_colors.insert(scene.fluid_colors.begin(), {0.1f, 0.35f, 0.8f});
  scene.first_granular = 1;
  World world(world_def(pbd::DeviceKind::cpu, spacing));
  const FluidId water = world.create_fluid({}), sand = world.create_granular({});
  const auto in_heap = [](Vec3 p) { return p.y < 0.5f - 0.7f * std::hypot(p.x, p.z); };
  world.add_particles(
      sand, points_where(spacing, {0.8f, 0.6f, 0.6f}, [&](Vec3 p) { return p.y > 0 && in_heap(p); }));
  world.add_particles(water, points_where(spacing, {0.8f, 0.2f, 0.6f},
                                          [&](Vec3 p) { return p.y > 0 && p.x > 0 && !in_heap(p); }));
  expect_drawn("grains", scene, {.ellipsoids = world.ellipsoids(), .fluids = world.fluids()});
}

/// A shallow pool and a film on a wall, of coarse particles. They end at the edges of the vessel, without
/// scallops.
TEST_F(FluidPictures, Walls) {
  constexpr float coarse = 0.1f;
  io::PreviewScene scene = on_ground({0.7f, 0.75f, 1.9f}, {0, 0.3f, 0}, 30);
  scene.particle_spacing = coarse;
  scene.shapes.push_back(
      shape(ContainerGeometry{{0.4f, 0.4f, 0.4f}, {{Face::y_high, std::nullopt}}}, {0, 0.4f, 0}));
  const Water water(
      points_where(coarse, {0.4f, 0.6f, 0.4f},
                   [](Vec3 p) { return p.y > 0 && (p.y < 0.1f || (p.z > 0.3f && p.y < 0.5f)); }),
      coarse);
  expect_drawn("walls", scene, water.moment());
}

/// Single particles, round at rest and long where they are fast, before a pool and before the ground.
TEST_F(FluidPictures, DropsBeforeAPool) {
  io::PreviewScene scene = on_ground({0, 0.9f, 2.2f}, {0, 0.25f, 0}, 30);
  std::vector<Vec3> points =
      points_where(spacing, {0.8f, 0.3f, 0.8f}, [](Vec3 p) { return p.y > 0 && p.y < 0.25f && p.x < 0.35f; });
  const std::size_t drops = points.size();
  for (int i = 0; i < 14; ++i) {
    const float t = static_cast<float>(i);
    points.push_back({0.12f * t - 0.8f, 0.42f + 0.12f * std::sin(2.1f * t), 0.9f});
  }
  const Water water(points, spacing);
  std::vector<Vec3> velocities(points.size());
  for (std::size_t i = drops; i < points.size(); i += 2) velocities[i] = {3, -5, 0};
  render::Moment moment = water.moment();
  moment.velocities = velocities;
  expect_drawn("drops_before_pool", scene, moment);
}

/// All of it at once.
TEST_F(FluidPictures, Splash) {
  io::PreviewScene scene = around_splash();
  scene.shapes = {
      shape(ContainerGeometry{{0.92f, 0.6f, 0.92f}, {{Face::y_high, std::nullopt}}}, {0, -0.3f, 0}),
      shape(SphereGeometry{0.2f}, {-0.5f, -0.25f, 0.3f})};
  expect_drawn("splash", scene, splash().moment());
}

}  // namespace
}  // namespace meniscus::tests
