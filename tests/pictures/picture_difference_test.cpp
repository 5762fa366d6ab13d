// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the difference between pictures.
#include "tests/pictures/picture_difference.h"

#include <gtest/gtest.h>

#include <random>

namespace meniscus::tests {
namespace {

/// Stripes at a slant, each `width` pixels wide, with soft edges.
io::Image stripes(double width, double shift = 0, int contrast = 100) {
  io::Image image{64, 48, std::vector<uint8_t>(3 * 64 * 48)};
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double wave = std::sin((x + 0.4 * y + shift) * 3.14159 / width);
      const double value = 120 + contrast * std::clamp(2 * wave, -1.0, 1.0);
      std::fill_n(&image.rgb[3 * (std::size_t{64} * y + x)], 3, static_cast<uint8_t>(value));
    }
  }
  return image;
}

TEST(PictureDifference, OfEqualPicturesIsNone) {
  const PictureDifference d = difference_of(stripes(6), stripes(6));
  EXPECT_EQ(d.worst_color, 0);
  EXPECT_EQ(d.mean_color, 0);
  EXPECT_NEAR(d.structure, 1, 1e-12);
}

TEST(PictureDifference, RoundingAndEdgesThatMoveByAHairAreAcceptable) {
  io::Image noisy = stripes(6, 0.03);
  std::mt19937 random(1);
  for (uint8_t& value : noisy.rgb) value = static_cast<uint8_t>(value + random() % 3 - 1);
  EXPECT_TRUE(difference_of(stripes(6), noisy).acceptable());
}

TEST(PictureDifference, WhatIsSeenIsNotAcceptable) {
  const io::Image golden = stripes(6);
  EXPECT_FALSE(difference_of(golden, stripes(6, 1)).acceptable()) << "moved by a pixel";
  EXPECT_FALSE(difference_of(golden, stripes(6, 0, 80)).acceptable()) << "paler";
  io::Image brighter = golden, tinted = golden, spot = golden;
  for (uint8_t& value : brighter.rgb) value = static_cast<uint8_t>(value + 8);
  EXPECT_FALSE(difference_of(golden, brighter).acceptable()) << "brighter";
  for (std::size_t i = 2; i < tinted.rgb.size(); i += 3)
    tinted.rgb[i] = static_cast<uint8_t>(tinted.rgb[i] - 12);
  EXPECT_FALSE(difference_of(golden, tinted).acceptable()) << "yellower";
  for (int y = 20; y < 26; ++y) {
    for (int x = 30; x < 36; ++x) spot.rgb[3 * (std::size_t{64} * y + x)] = 255;
  }
  EXPECT_FALSE(difference_of(golden, spot).acceptable()) << "a red spot";
}

/// CIE's own distances: white from black is 100, sRGB's red from its green 170.6 and from its blue 176.3.
TEST(PictureDifference, ColoursAreApartAsCieHasThem) {
  const auto flat = [](uint8_t r, uint8_t g, uint8_t b) {
    io::Image image{8, 8, {}};
    for (int i = 0; i < 64; ++i) image.rgb.insert(image.rgb.end(), {r, g, b});
    return image;
  };
  EXPECT_NEAR(difference_of(flat(255, 255, 255), flat(0, 0, 0)).worst_color, 100, 0.1);
  EXPECT_NEAR(difference_of(flat(255, 0, 0), flat(0, 255, 0)).worst_color, 170.6, 0.5);
  EXPECT_NEAR(difference_of(flat(255, 0, 0), flat(0, 0, 255)).worst_color, 176.3, 0.5);
}

}  // namespace
}  // namespace meniscus::tests
