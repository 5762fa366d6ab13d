// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of how the preview draws cloth and ropes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sdk/io/preview/preview.h"

namespace meniscus::io {
namespace {

struct Pixel {
  int r, g, b;
};

Pixel at(const Image& image, int x, int y) {
  const std::size_t i = 3 * (static_cast<std::size_t>(y) * image.width + x);
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

/// Small, and straight at the origin from the front.
PreviewScene small_scene() {
  PreviewScene scene;
  scene.cloth_colors = {{0.7f, 0.05f, 0.05f}};
  scene.rope_colors = {{0.05f, 0.6f, 0.05f}};
  scene.camera = SceneCamera{{0, 0, 4}, {0, 0, 0}, 35};
  scene.width = 320;
  scene.height = 180;
  return scene;
}

/// A square of 1 m that faces the camera, or has its back to it.
ClothFrame square(bool faces_camera) {
  ClothFrame frame;
  frame.vertices = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {-0.5f, 0.5f, 0}, {0.5f, 0.5f, 0}};
  frame.triangles = {{0, 1, 2}, {1, 3, 2}};
  frame.normals.assign(4, {0, 0, 1});
  if (!faces_camera) {
    for (auto& t : frame.triangles) std::swap(t[1], t[2]);
    frame.normals.assign(4, {0, 0, -1});
  }
  frame.velocities.assign(4, {0, 0, 0});
  frame.strains = {0, 0};
  frame.pieces = {0, 0};
  frame.vertex_pieces = {0, 0, 0, 0};
  frame.names = {"square"};
  return frame;
}

bool is_red(Pixel p) {
  return p.r > p.g + 40 && p.r > p.b + 40;
}
bool is_green(Pixel p) {
  return p.g > p.r + 40 && p.g > p.b + 40;
}

template <class IsIt>
int pixels(const Image& image, IsIt is_it) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) count += is_it(at(image, x, y));
  }
  return count;
}

/// Pixels that a metre has at the origin.
const double scale = 90 / std::tan(17.5 * M_PI / 180) / 4;

TEST(PreviewCloth, CoversItsAreaInItsColour) {
  const Image image = render_preview({}, small_scene(), {}, square(true));
  EXPECT_NEAR(pixels(image, is_red), scale * scale, 0.05 * scale * scale) << "its border takes in some";
  EXPECT_TRUE(is_red(at(image, 160, 90)));
  EXPECT_FALSE(is_red(at(image, 10, 90)));
}

TEST(PreviewCloth, IsSeenFromBehindAndDarkerThere) {
  const Image front = render_preview({}, small_scene(), {}, square(true));
  const Image back = render_preview({}, small_scene(), {}, square(false));
  EXPECT_NEAR(pixels(back, is_red), pixels(front, is_red), 0.02 * scale * scale);
  EXPECT_LT(at(back, 160, 90).r, at(front, 160, 90).r - 30);
}

TEST(PreviewCloth, IsLitByTheNormalsOfItsVertices) {
  ClothFrame tilted = square(true);
  for (Vec3& n : tilted.normals) n = {0.7f, -0.6f, 0.4f};  // away from the lamp
  const Image lit = render_preview({}, small_scene(), {}, square(true));
  const Image dark = render_preview({}, small_scene(), {}, tilted);
  EXPECT_LT(at(dark, 160, 90).r, at(lit, 160, 90).r - 30);
}

TEST(PreviewCloth, IsInTheChosenView) {
  PreviewScene scene = small_scene();
  scene.camera.reset();
  ClothFrame far_off = square(true);
  for (Vec3& p : far_off.vertices) p.x += 30;
  EXPECT_GT(pixels(render_preview({}, scene, {}, far_off), is_red), 1000);
}

TEST(PreviewCloth, WhatIsNotFiniteIsLeftOut) {
  ClothFrame broken = square(true);
  broken.vertices[3].x = std::numeric_limits<float>::quiet_NaN();
  const int half = pixels(render_preview({}, small_scene(), {}, broken), is_red);
  EXPECT_NEAR(half, 0.5 * scale * scale, 0.03 * scale * scale);
}

TEST(PreviewCloth, RopesAreAsThickAsTheyAre) {
  RopeFrame ropes;
  ropes.vertices = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  ropes.velocities.assign(3, {0, 0, 0});
  ropes.lines = {{0, 1, 2}};
  ropes.radii = {0.05f};
  ropes.names = {"rope"};
  const Image image = render_preview({}, small_scene(), {}, {}, ropes);
  EXPECT_TRUE(is_green(at(image, 130, 90)));
  EXPECT_NEAR(pixels(image, is_green), 2.08 * 0.1 * scale * scale, 0.15 * 0.2 * scale * scale);
}

}  // namespace
}  // namespace meniscus::io
