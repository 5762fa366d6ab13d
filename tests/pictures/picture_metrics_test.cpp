// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the figures of pictures.
#include "tests/pictures/picture_metrics.h"

#include <gtest/gtest.h>

namespace meniscus::tests {
namespace {

constexpr int size = 40;

io::Image flat(uint8_t r, uint8_t g, uint8_t b) {
  io::Image image{size, size, {}};
  for (int i = 0; i < size * size; ++i) image.rgb.insert(image.rgb.end(), {r, g, b});
  return image;
}

void set(io::Image& image, int x, int y, uint8_t value) {
  for (int k = 0; k < 3; ++k) image.rgb[static_cast<std::size_t>(3 * (y * size + x) + k)] = value;
}

/// Fluid in the right half.
std::vector<std::array<float, 4>> half_wet() {
  std::vector<std::array<float, 4>> surface;
  for (int i = 0; i < size * size; ++i) surface.push_back({0, 0, 1, i % size >= size / 2 ? 1.0f : 0.0f});
  return surface;
}

TEST(PictureMetrics, GrainIsNoiseWhereThereIsFluid) {
  io::Image dry = flat(100, 100, 100), wet = dry;
  set(dry, 8, 20, 140);
  set(wet, 30, 20, 140);
  const io::Image bare = flat(100, 100, 100);
  EXPECT_EQ(metrics_of(dry, bare, half_wet()).noise, 0);
  // 160 at the grain and 40 at each of its neighbours, over 19 × 38 pixels.
  EXPECT_NEAR(metrics_of(wet, bare, half_wet()).noise, 320.0 / (19 * 38), 1e-6);
}

TEST(PictureMetrics, FoamIsWhatIsBrighterThanWithoutIt) {
  io::Image foamy = flat(100, 100, 100);
  for (int x = 20; x < 30; ++x) set(foamy, x, 5, 120);
  const PictureMetrics m = metrics_of(foamy, flat(100, 100, 100), half_wet());
  EXPECT_NEAR(m.foam_cover, 10.0 / (size * size), 1e-9);
  EXPECT_NEAR(m.brightness, 100 + 200.0 / (size * size), 1e-6);
}

TEST(PictureMetrics, DarkBlueIsDarkAndBlue) {
  const io::Image grey = flat(60, 60, 60), blue = flat(10, 40, 150), pale = flat(120, 160, 220);
  EXPECT_EQ(metrics_of(blue, blue, half_wet()).dark_blue, 1);
  EXPECT_EQ(metrics_of(grey, grey, half_wet()).dark_blue, 0);
  EXPECT_EQ(metrics_of(pale, pale, half_wet()).dark_blue, 0);
}

TEST(PictureMetrics, AStepIsASharperEdgeThanARamp) {
  io::Image step = flat(50, 50, 50), ramp = step;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      set(step, x, y, x < size / 2 ? 50 : 150);
      set(ramp, x, y, static_cast<uint8_t>(50 + 100 * x / size));
    }
  }
  EXPECT_NEAR(metrics_of(step, step, half_wet()).edge, 50, 1);
  EXPECT_LT(metrics_of(ramp, ramp, half_wet()).edge, 5);
}

TEST(PictureMetrics, FlickerIsADifferenceOfLuma) {
  io::Image image = flat(100, 100, 100), other = image;
  EXPECT_EQ(flicker_of(image, other).mean, 0);
  for (int x = 0; x < size; ++x) set(other, x, 3, 151);  // 20 % of white, in one row of 40
  EXPECT_NEAR(flicker_of(image, other).mean, 0.5, 1e-9);
  EXPECT_NEAR(flicker_of(image, other).highest_hundredth, 20, 1e-9);
}

}  // namespace
}  // namespace meniscus::tests
