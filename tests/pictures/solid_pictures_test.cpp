// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Pictures without fluid: backdrop, solids and their shadows, glass, cloth, ropes; the tone curve and
// antialiasing.
#include <cmath>
#include <numbers>

#include "sdk/render/still.h"
#include "tests/pictures/golden.h"

namespace meniscus::tests {
namespace {

class SolidPictures : public GoldenTest {};

/// A sheet bent about the vertical, like an open book's page, of columns of `color`.
io::ClothFrame bent_sheet(float radius, float height, int columns, float degrees) {
  io::ClothFrame frame;
  for (int i = 0; i <= columns; ++i) {
    const float angle = (static_cast<float>(i) / static_cast<float>(columns) - 0.5f) * degrees *
                        std::numbers::pi_v<float> / 180;
    const Vec3 outwards{std::sin(angle), 0, std::cos(angle)};
    for (const float y : {0.0f, height}) {
      frame.vertices.push_back(radius * outwards + Vec3{0, y, 0});
      frame.normals.push_back(outwards);
    }
    if (i == 0) continue;
    const auto k = static_cast<uint32_t>(2 * i);
    frame.triangles.insert(frame.triangles.end(), {{k - 2, k, k + 1}, {k - 2, k + 1, k - 1}});
  }
  frame.pieces.assign(frame.triangles.size(), 0);
  frame.vertex_pieces.assign(frame.vertices.size(), 0);
  frame.names = {"sheet"};
  return frame;
}

TEST_F(SolidPictures, SkyAndGround) {
  expect_drawn("sky_and_ground", on_ground({0, 0.8f, 4}, {0, 1.6f, 0}, 75));
}

TEST_F(SolidPictures, Solids) {
  io::PreviewScene scene = on_ground({0.3f, 2.2f, 3.2f}, {0, 0.2f, 0});
  scene.shapes.push_back(shape(SphereGeometry{0.3f}, {-0.7f, 0.3f, 0.3f}));
  scene.shapes.push_back(shape(BoxGeometry{{0.25f, 0.25f, 0.25f}}, {0.1f, 0.25f, 0.2f}));
  scene.shapes.back().pose.rotation = {0, 0.3826834f, 0, 0.9238795f};
  scene.shapes.push_back(shape(CylinderGeometry{0.2f, 0.3f}, {0.8f, 0.3f, 0}));
  scene.shapes.push_back(shape(CapsuleGeometry{0.15f, 0.2f}, {-0.3f, 0.35f, -0.6f}));
  scene.bodies.resize(1);
  scene.bodies[0].geometry =
      HullGeometry{{{-0.3f, 0, -0.3f}, {0.3f, 0, -0.3f}, {0.3f, 0, 0.3f}, {-0.3f, 0, 0.3f}, {0, 0.5f, 0}}};
  scene.bodies[0].pose.position = {0.4f, 0, -0.7f};
  expect_drawn("solids", scene);
}

TEST_F(SolidPictures, Shadows) {
  io::PreviewScene scene = on_ground({0.5f, 3, 1.6f}, {0.3f, 0, 0});
  for (const float x : {-0.8f, -0.2f, 0.4f})
    scene.shapes.push_back(shape(BoxGeometry{{0.05f, 0.5f, 0.05f}}, {x, 0.5f, 0.3f}));
  scene.shapes.push_back(shape(SphereGeometry{0.2f}, {-0.3f, 0.6f, -0.5f}));
  expect_drawn("shadows", scene);
}

/// Corners, and the ground beneath a ball, are darker than what lies open, also where the sun does not reach.
TEST_F(SolidPictures, ContactShading) {
  io::PreviewScene scene = on_ground({1.1f, 0.8f, 1.0f}, {0, 0.15f, -0.1f});
  scene.shapes.push_back(shape(SphereGeometry{0.3f}, {0.1f, 0.29f, 0.1f}));
  scene.shapes.push_back(shape(BoxGeometry{{0.5f, 0.4f, 0.05f}}, {0, 0.4f, -0.3f}));
  scene.shapes.push_back(shape(BoxGeometry{{0.05f, 0.4f, 0.5f}}, {-0.5f, 0.4f, 0}));
  expect_drawn("contact_shading", scene);
}

/// A container in front of a dark wall, seen at a low angle: its glass mirrors the sky.
TEST_F(SolidPictures, Glass) {
  io::PreviewScene scene = on_ground({1.6f, 0.75f, 1.5f}, {0, 0.4f, 0});
  scene.bodies.resize(1);
  scene.bodies[0].geometry = BoxGeometry{{1.5f, 1, 0.05f}};
  scene.bodies[0].pose.position = {0, 1, -0.8f};
  scene.shapes.push_back(
      shape(ContainerGeometry{{0.6f, 0.4f, 0.4f}, {{Face::y_high, std::nullopt}}}, {0, 0.42f, 0}));
  expect_drawn("glass", scene);
}

TEST_F(SolidPictures, ClothFromBothSides) {
  io::PreviewScene scene = on_ground({0, 1.5f, 2.6f}, {0, 0.35f, 0});
  scene.cloth_colors = {{0.65f, 0.08f, 0.06f}};
  const io::ClothFrame sheet = bent_sheet(0.7f, 0.8f, 24, 300);
  expect_drawn("cloth", scene, {.cloth = sheet});
}

/// From close by, so that a thread has seven pixels.
TEST_F(SolidPictures, Weave) {
  io::PreviewScene scene = on_ground({0.05f, 0.22f, 0.5f}, {0, 0.2f, 0.3f}, 20);
  scene.cloth_colors = {{0.55f, 0.42f, 0.25f}};
  io::ClothFrame sheet = bent_sheet(0.3f, 0.4f, 12, 90);
  for (const auto& triangle : sheet.triangles) {
    for (const uint32_t v : triangle)
      sheet.texture.push_back({static_cast<float>(v / 2) / 12, static_cast<float>(v % 2)});
  }
  expect_drawn("weave", scene, {.cloth = sheet});
}

/// The upper border of a sheet, which is as thick as cloth from its side as well.
TEST_F(SolidPictures, Hem) {
  io::PreviewScene scene = on_ground({0.1f, 0.52f, 0.5f}, {0, 0.4f, 0.28f}, 20);
  scene.cloth_colors = {{0.2f, 0.3f, 0.6f}};
  expect_drawn("hem", scene, {.cloth = bent_sheet(0.3f, 0.4f, 12, 90)});
}

/// The shadow of a bar on posts is softer than that of a bar that lies on the ground.
TEST_F(SolidPictures, SoftShadows) {
  io::PreviewScene scene = on_ground({0.3f, 1, 0.5f}, {0.3f, 0, 0.15f}, 30);
  scene.shapes.push_back(shape(BoxGeometry{{0.05f, 0.05f, 0.6f}}, {0, 0.05f, 0}));
  scene.shapes.push_back(shape(BoxGeometry{{0.05f, 0.05f, 0.6f}}, {0, 0.8f, 0}));
  expect_drawn("soft_shadows", scene);
}

/// The ground is far behind what the map of the shadows holds.
TEST_F(SolidPictures, FarShadow) {
  io::PreviewScene scene = on_ground({2, 3, 3}, {1.2f, 0, -0.3f}, 40);
  scene.shapes.push_back(shape(BoxGeometry{{0.25f, 0.1f, 0.25f}}, {0, 2, 0}));
  expect_drawn("far_shadow", scene);
}

/// Of three boxes the one in the middle is at the camera's target.
TEST_F(SolidPictures, DepthOfField) {
  io::PreviewScene scene = on_ground({0.9f, 0.5f, 2}, {0, 0.25f, 0});
  for (const float z : {-1.6f, 0.0f, 0.9f})
    scene.shapes.push_back(shape(BoxGeometry{{0.12f, 0.25f, 0.12f}}, {0.3f * z, 0.25f, z}));
  render::Renderer renderer(scene, {});
  expect_picture("depth_of_field", render::draw_still(renderer, {}, {.samples = 12, .aperture = 0.15f}));
  EXPECT_EQ(renderer.camera().position, scene.camera->position);
}

/// One ball flies to the right, a box turns, and one ball is at rest.
TEST_F(SolidPictures, MotionBlur) {
  io::PreviewScene scene = on_ground({0, 1, 3}, {0, 0.5f, 0});
  scene.bodies.resize(3);
  scene.bodies[0].geometry = scene.bodies[2].geometry = SphereGeometry{0.2f};
  scene.bodies[1].geometry = BoxGeometry{{0.3f, 0.05f, 0.05f}};
  std::vector<BodyState> states(3);
  for (std::size_t i = 0; i < 3; ++i)
    states[i].pose.position = states[i].centre_of_mass = {0.75f * (static_cast<float>(i) - 1), 0.5f, 0};
  states[0].velocity = {4, 0, 0};
  states[1].angular_velocity = {0, 0, 12};
  const render::Moment moment{.bodies = states};
  render::Renderer renderer(scene, moment);
  expect_picture("motion_blur", render::draw_still(renderer, moment, {.samples = 12, .shutter = 0.08f}));
}

/// The mean of equal pictures is that picture, but for its rounding.
TEST_F(SolidPictures, SamplesOfOnePicture) {
  io::PreviewScene scene = on_ground({0.9f, 0.5f, 2}, {0, 0.25f, 0});
  scene.shapes.push_back(
      shape(ContainerGeometry{{0.6f, 0.4f, 0.4f}, {{Face::y_high, std::nullopt}}}, {0, 0.42f, 0}));
  render::Renderer renderer(scene, {});
  const io::Image one = renderer.draw({}), mean = render::draw_still(renderer, {}, {.samples = 3});
  int most = 0;
  for (std::size_t i = 0; i < one.rgb.size(); ++i) most = std::max(most, std::abs(one.rgb[i] - mean.rgb[i]));
  EXPECT_LE(most, 1);
}

TEST_F(SolidPictures, SettingsOfStillsAreChecked) {
  render::Renderer renderer(on_ground({0, 1, 3}, {0, 0, 0}), {});
  for (const render::StillSettings& wrong : {render::StillSettings{.samples = 0},
                                             {.samples = 5000},
                                             {.samples = 2, .aperture = -1},
                                             {.samples = 2, .shutter = NAN}})
    EXPECT_THROW(render::draw_still(renderer, {}, wrong), Error);
}

TEST_F(SolidPictures, Ropes) {
  io::PreviewScene scene = on_ground({0, 1.2f, 2.4f}, {0, 0.4f, 0});
  scene.rope_colors = {{0.65f, 0.45f, 0.12f}, {0.1f, 0.3f, 0.12f}};
  io::RopeFrame frame;
  frame.lines.resize(2);
  for (uint32_t i = 0; i < 60; ++i) {  // a coil, and a line through it
    const float t = static_cast<float>(i) / 59, angle = 6 * std::numbers::pi_v<float> * t;
    frame.vertices.push_back({1.4f * t - 0.7f, 0.45f + 0.3f * std::cos(angle), 0.3f * std::sin(angle)});
    frame.lines[0].push_back(i);
  }
  frame.vertices.insert(frame.vertices.end(), {{-0.9f, 0.45f, 0}, {0.9f, 0.45f, 0}});
  frame.lines[1] = {60, 61};
  frame.radii = {0.05f, 0.03f};
  expect_drawn("ropes", scene, {.ropes = frame});
}

/// Strips of cloth from nearly black to brighter than white.
TEST_F(SolidPictures, ToneCurve) {
  io::PreviewScene scene = on_ground({0, 2.4f, 1}, {0, 0, 0});
  io::ClothFrame strips;
  for (uint32_t i = 0; i < 10; ++i) {
    const float x = 0.2f * static_cast<float>(i) - 1, level = 0.005f * std::pow(2.0f, static_cast<float>(i));
    scene.cloth_colors.push_back({level, 0.9f * level, 0.7f * level});
    for (const Vec3 corner :
         {Vec3{x, 0.01f, 0.6f}, {x + 0.19f, 0.01f, 0.6f}, {x + 0.19f, 0.01f, -0.6f}, {x, 0.01f, -0.6f}}) {
      strips.vertices.push_back(corner);
      strips.normals.push_back({0, 1, 0});
    }
    strips.triangles.insert(strips.triangles.end(),
                            {{4 * i, 4 * i + 1, 4 * i + 2}, {4 * i, 4 * i + 2, 4 * i + 3}});
    strips.pieces.insert(strips.pieces.end(), 2, i);
  }
  expect_drawn("tone_curve", scene, {.cloth = strips});
}

/// Bars of pale wood before a dark wall, at slants of all kinds.
TEST_F(SolidPictures, SmoothEdges) {
  io::PreviewScene scene = small_scene();
  scene.shapes = {shape(PlaneGeometry{}, {0, -50, 0}), shape(BoxGeometry{{3, 3, 0.1f}}, {0, 0, -1})};
  scene.rope_colors.assign(40, {0.8f, 0.75f, 0.6f});
  io::RopeFrame rays;
  for (uint32_t i = 0; i < 40; ++i) {
    const float angle = (static_cast<float>(i) + 0.3f) * std::numbers::pi_v<float> / 20;
    const Vec3 direction{std::cos(angle), std::sin(angle), 0};
    rays.vertices.insert(rays.vertices.end(), {0.25f * direction, 1.5f * direction});
    rays.lines.push_back({2 * i, 2 * i + 1});
    rays.radii.push_back(0.025f);
  }
  expect_drawn("smooth_edges", scene, {.ropes = rays});
}

}  // namespace
}  // namespace meniscus::tests
