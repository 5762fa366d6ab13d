// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Pictures that show measured quantities.
#include <algorithm>

#include "sdk/render/legend.h"
#include "tests/bench/harness/render_bench.h"
#include "tests/expect_error.h"

namespace meniscus::tests {
namespace {

using render::ParticleView;
using render::ViewChoice;
using render::ViewData;

ViewChoice choice_of(const std::vector<std::string>& names) {
  return render::view_choice(names);
}

TEST(ViewChoiceTest, NamesMakeAChoice) {
  EXPECT_EQ(choice_of({}), ViewChoice{});
  const ViewChoice choice = choice_of({"contacts", "pressure", "strain"});
  EXPECT_EQ(choice.particles, ParticleView::pressure);
  EXPECT_TRUE(choice.contacts && choice.strain && !choice.normals && !choice.distances);
  for (const char* name : render::view_names()) EXPECT_NE(choice_of({name}), ViewChoice{}) << name;
}

TEST(ViewChoiceTest, WhatCannotBeChosenIsRefused) {
  expect_error(ErrorCode::invalid_argument, "speed", [] { choice_of({"sped"}); });
  expect_error(ErrorCode::invalid_argument, "'density' cannot", [] { choice_of({"speed", "density"}); });
}

TEST(ColorMapTest, LightnessGrowsWithTheValue) {
  const auto light = [](float place) {
    const Vec3 c = color_at(render::ColorMap::sequence, place);
    return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
  };
  for (int i = 0; i < 50; ++i) {
    EXPECT_LT(light(static_cast<float>(i) / 50), light(static_cast<float>(i + 1) / 50)) << i;
  }
  const Vec3 below = color_at(render::ColorMap::balance, 0), above = color_at(render::ColorMap::balance, 1);
  EXPECT_GT(below.z, below.x);
  EXPECT_GT(above.x, above.z);
}

/// A drop that falls on a floor beside a ball.
World falling_water() {
  World world(world_def(pbd::DeviceKind::cpu, 0.1f));
  world.create_shape(shape(PlaneGeometry{}));
  world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.5f, 0.5f, 0.5f}));
  for (int step = 0; step < 10; ++step) world.step(0.01f);
  return world;
}

ViewData measured(const World& world, const ViewChoice& choice) {
  return render::ViewMeter().measure(world, choice, {}, {{0, -0.2f, 0}, {1, 0.8f, 1}}, {0, 0, -1});
}

TEST(ViewMeterTest, ValuesAreThoseOfTheWorld) {
  const World world = falling_water();
  const ViewData speeds = measured(world, choice_of({"speed", "contacts"}));
  ASSERT_EQ(speeds.values.size(), world.particle_count());
  for (std::size_t i = 0; i < speeds.values.size(); ++i)
    EXPECT_EQ(speeds.values[i], length(world.velocities()[i]));
  EXPECT_GE(speeds.particles.high, *std::max_element(speeds.values.begin(), speeds.values.end()) * 0.5f);
  EXPECT_EQ(speeds.contacts.size(), world.particle_contacts().size());
  EXPECT_GT(speeds.contacts.size(), 0u);
  const ViewData pressures = measured(world, choice_of({"pressure"}));
  EXPECT_TRUE(std::equal(pressures.values.begin(), pressures.values.end(), world.pressures().begin()));
  EXPECT_TRUE(measured(world, {}).values.empty());
}

TEST(ViewMeterTest, DistancesAreToTheFloor) {
  const World world = falling_water();
  const render::DistanceSlice slice = measured(world, choice_of({"distances"})).slice;
  ASSERT_EQ(slice.distances.size(), std::size_t{1} * slice.columns * slice.rows);
  for (int j = 0; j < slice.rows; j += 10) {
    const float y =
        slice.corner.y + (static_cast<float>(j) + 0.5f) / static_cast<float>(slice.rows) * slice.up.y;
    if (y >= 0.4f) break;
    EXPECT_NEAR(slice.distances[std::size_t{1} * j * slice.columns], y, 1e-5f);
  }
}

TEST(ViewMeterTest, ThePlaneOfDistancesGoesThroughTheScene) {
  const World world = falling_water();
  ViewChoice choice = choice_of({"distances"});
  for (const float place : {0.0f, 0.5f, 1.0f}) {
    choice.plane = place;
    EXPECT_NEAR(measured(world, choice).slice.corner.z, place, 1e-6f);  // the box is 1 m deep
  }
}

TEST(ViewMeterTest, ScalesGrowAndNeverShrink) {
  World world(world_def(pbd::DeviceKind::cpu, 0.1f));
  const FluidId water = world.create_fluid({});
  render::ViewMeter meter;
  const auto scale = [&] {
    return meter.measure(world, choice_of({"speed"}), {}, {{-1, -1, -1}, {1, 1, 1}}, {0, 0, -1})
        .particles.high;
  };
  const Vec3 place[] = {{0, 0, 0}}, fast[] = {{0, 2.9f, 0}};
  const ParticleId first = world.add_particles(water, place, fast);
  EXPECT_EQ(scale(), 3);
  const Vec3 stop[] = {{0, -2.9f * world.particle_mass(water), 0}};
  world.apply_impulses(std::span(&first, 1), stop);
  EXPECT_EQ(scale(), 3);
}

TEST(LegendTest, ItTellsOfEachScale) {
  ViewData view;
  EXPECT_TRUE(legend_of(view).empty());
  view.choice = choice_of({"pressure", "strain"});
  ASSERT_EQ(legend_of(view).size(), 2u);
  io::Image image{400, 300, std::vector<uint8_t>(360000, 100)};
  const io::Image before = image;
  draw_legend(image, view);
  int changed = 0, letters = 0;
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 400; ++x) {
      changed += difference(at(image, x, y), at(before, x, y)) > 0;
      letters += sum(at(image, x, y)) == 3 * 245;
      if (y >= 200) continue;
      ASSERT_EQ(difference(at(image, x, y), at(before, x, y)), 0);
    }
  }
  EXPECT_GT(changed, 8000);
  EXPECT_GT(letters, 200);
}

class ViewPictureTest : public RenderTest {
 protected:
  static io::PreviewScene scene() {
    io::PreviewScene scene = small_scene(0.4f);
    scene.shapes = {shape(PlaneGeometry{}, {0, -50, 0})};
    return scene;
  }
  /// Two balls, left and right, under a view.
  struct Pair {
    Pixel left, right;
  };
  Pair pair_of(ParticleView particles, const render::Scale& scale, float left, float right) {
    ViewData view;
    view.choice.particles = particles;
    view.particles = scale;
    view.values = {left, right};
    const Ellipsoid balls[] = {{{-0.4f, 0, 0}, {0.2f, 0.2f, 0.2f}, {}},
                               {{0.4f, 0, 0}, {0.2f, 0.2f, 0.2f}, {}}};
    const uint32_t fluids[] = {0, 1};
    io::PreviewScene s = scene();
    s.fluid_colors = {{0.8f, 0.05f, 0.05f}, {0.05f, 0.7f, 0.05f}};
    const io::Image image = draw(s, {.ellipsoids = balls, .fluids = fluids, .view = &view});
    return {at(image, 55, 60), at(image, 105, 60)};
  }
};

TEST_F(ViewPictureTest, BallsHaveTheColoursOfTheirValues) {
  const Pair seen = pair_of(ParticleView::speed, {0, 2, render::ColorMap::sequence, ""}, 0.2f, 2);
  EXPECT_GT(seen.left.b, seen.left.r + 20);
  EXPECT_GT(seen.right.r, seen.right.b + 40);
  EXPECT_GT(sum(seen.right), sum(seen.left) + 100);
  const Pair signs = pair_of(ParticleView::density_error, {-1, 1, render::ColorMap::balance, ""}, -1, 1);
  EXPECT_GT(signs.left.b, signs.left.r + 40);
  EXPECT_GT(signs.right.r, signs.right.b + 40);
  const Pair phases = pair_of(ParticleView::phase, {}, 0, 1);
  EXPECT_GT(phases.left.r, phases.left.g + 60);
  EXPECT_GT(phases.right.g, phases.right.r + 60);
}

TEST_F(ViewPictureTest, ContactsAreLinesAlongTheirNormals) {
  ViewData view;
  view.choice.contacts = true;
  view.contacts = {{.point = {0, 0, 0}, .normal = {0, 1, 0}, .impulse = {}}};
  const io::Image with = draw(scene(), {.view = &view}), plain = draw(scene());
  int changed = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      if (difference(at(with, x, y), at(plain, x, y)) <= 40) continue;
      ++changed;
      EXPECT_TRUE(std::abs(x - 80) < 4 && y <= 62 && y > 20) << x << ", " << y;
    }
  }
  EXPECT_GT(changed, 40);
}

TEST_F(ViewPictureTest, SolidsHideLinesBehindThem) {
  ViewData view;
  view.choice.contacts = true;
  view.contacts = {{.point = {0, -0.2f, -1}, .normal = {0, 1, 0}, .impulse = {}}};
  io::PreviewScene s = scene();
  s.bodies.resize(1);
  s.bodies[0].geometry = BoxGeometry{{0.7f, 0.7f, 0.1f}};
  const io::Image hidden = draw(s, {.view = &view});
  EXPECT_EQ(hidden.rgb, draw(s).rgb);
  view.contacts[0].point.z = 1;
  EXPECT_NE(draw(s, {.view = &view}).rgb, hidden.rgb);
}

TEST_F(ViewPictureTest, WhatIsShownOnceLeavesNoTrace) {
  ViewData needle, ball;
  needle.choice.contacts = true;
  needle.contacts = {{.point = {0, 0, 0}, .normal = {0, 1, 0}, .impulse = {}}};
  ball.choice.particles = ParticleView::speed;
  ball.values = {1};
  const Ellipsoid balls[] = {{{0.1f, 0, 0}, {0.2f, 0.2f, 0.2f}, {}}};
  const uint32_t fluids[] = {0};
  io::PreviewScene s = scene();
  s.shapes.push_back(shape(ContainerGeometry{{0.3f, 0.3f, 0.3f}, {}}));
  render::Renderer renderer(s, {});
  const io::Image plain = renderer.draw({});
  EXPECT_NE(renderer.draw({.view = &needle}).rgb, plain.rgb);
  EXPECT_EQ(renderer.draw({}).rgb, plain.rgb);
  EXPECT_NE(renderer.draw({.ellipsoids = balls, .fluids = fluids, .view = &ball}).rgb, plain.rgb);
  EXPECT_EQ(renderer.draw({}).rgb, plain.rgb);
}

TEST_F(ViewPictureTest, NormalsAreColours) {
  io::PreviewScene s = scene();
  s.bodies.resize(1);
  s.bodies[0].geometry = BoxGeometry{{0.5f, 0.5f, 0.5f}};
  ViewData view;
  view.choice.normals = true;
  const io::Image image = draw(s, {.view = &view});
  EXPECT_LT(difference(at(image, 80, 60), {128, 128, 255}), 12);  // towards the camera, along z
  EXPECT_LT(sum(at(image, 5, 5)), 120);                           // the sky
  Water water(points_where(0.05f, {0.3f, 0.3f, 0.3f}, [](Vec3 p) { return length(p) < 0.3f; }));
  render::Moment moment = water.moment();
  moment.view = &view;
  io::PreviewScene wet = small_scene();
  const io::Image ball = draw(wet, moment);
  EXPECT_GT(at(ball, 80, 60).b, 225);
  EXPECT_GT(at(ball, 80, 50).g, at(ball, 80, 70).g + 60);
}

TEST_F(ViewPictureTest, ClothIsColouredByItsStrain) {
  io::ClothFrame sheet;
  sheet.vertices = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}};
  sheet.normals.assign(4, {0, 0, 1});
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  sheet.pieces = {0, 0};
  sheet.vertex_pieces.assign(4, 0);
  sheet.strains = {0, 0.1f};
  ViewData view;
  view.choice.strain = true;
  view.strain = {0, 0.1f, render::ColorMap::sequence, ""};
  const io::Image image = draw(scene(), {.cloth = sheet, .view = &view});
  const Pixel slack = at(image, 95, 75), tight = at(image, 65, 45);
  EXPECT_GT(slack.b, slack.r + 15);
  EXPECT_GT(tight.r, tight.b + 40);
}

TEST_F(ViewPictureTest, ASliceIsBlueInsideAndRedOutside) {
  ViewData view;
  view.choice.distances = true;
  view.distances = {-1, 1, render::ColorMap::balance, "m"};
  view.slice = {{-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0}, 40, 40, {}};
  for (int j = 0; j < 40; ++j) {
    for (int i = 0; i < 40; ++i) view.slice.distances.push_back((static_cast<float>(i) + 0.5f) / 20 - 1);
  }
  const io::Image image = draw(scene(), {.view = &view});
  const Pixel inside = at(image, 58, 60), outside = at(image, 99, 60);
  EXPECT_GT(inside.b, inside.r + 40);
  EXPECT_GT(outside.r, outside.b + 40);
}

}  // namespace
}  // namespace meniscus::tests
