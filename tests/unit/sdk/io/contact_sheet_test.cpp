// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of contact sheets of frames.
#include "sdk/io/contact_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace meniscus::io {
namespace {

Image flat(int width, int height, uint8_t value) {
  return {width, height, std::vector<uint8_t>(std::size_t{3} * width * height, value)};
}

uint8_t red(const Image& image, int x, int y) {
  return image.rgb[3 * (std::size_t{1} * y * image.width + x)];
}

TEST(ContactSheet, WantsTwiceAsManyFramesAtEqualDistancesAndTheLast) {
  for (const int frames : {24, 25, 48, 250, 100'000'000}) {
    const ContactSheet sheet(frames);
    std::vector<int> taken;
    for (int frame = 1; frame <= std::min(frames, 1000); ++frame) {
      if (sheet.wants(frame)) taken.push_back(frame);
    }
    EXPECT_TRUE(sheet.wants(frames));
    if (frames > 1000) continue;
    ASSERT_EQ(taken.size(), 24u) << frames;
    for (std::size_t i = 1; i < 24; ++i) EXPECT_NEAR(taken[i] - taken[i - 1], frames / 24.0, 1) << frames;
  }
}

/// The shots of 24 images with these values.
std::vector<int> shots_of(const std::vector<int>& values) {
  ContactSheet sheet(static_cast<int>(values.size()));
  for (const int value : values) sheet.add(flat(8, 4, static_cast<uint8_t>(value)));
  const Image image = sheet.image();
  std::vector<int> shots;
  for (int k = 0; k < 12; ++k) shots.push_back(red(image, k % 4 * 12, k / 4 * 8));
  return shots;
}

TEST(ContactSheet, ChoosesShotsWhereSomethingMoves) {
  // At rest, then in motion for eleven images, then at rest again.
  std::vector<int> values;
  for (int i = 0; i < 24; ++i) values.push_back(10 * std::clamp(i - 6, 0, 11));
  const std::vector<int> shots = shots_of(values);
  EXPECT_EQ(shots.front(), 0);
  EXPECT_EQ(shots.back(), 110);
  EXPECT_LE(std::count(shots.begin(), shots.end(), 0), 2);
  EXPECT_LE(std::count(shots.begin(), shots.end(), 110), 2);
  EXPECT_TRUE(std::is_sorted(shots.begin(), shots.end()));
}

TEST(ContactSheet, ChoosesEvenlyWhereMotionIsEvenOrThereIsNone) {
  std::vector<int> values;
  for (int i = 0; i < 24; ++i) values.push_back(10 * i);
  const std::vector<int> shots = shots_of(values);
  for (std::size_t k = 1; k < 12; ++k) EXPECT_NEAR(shots[k] - shots[k - 1], 230.0 / 11, 10);
  EXPECT_EQ(shots_of(std::vector<int>(24, 7)), std::vector<int>(12, 7));
}

TEST(ContactSheet, TakesAllOfAShortRun) {
  const ContactSheet sheet(5);
  for (int frame = 1; frame <= 5; ++frame) EXPECT_TRUE(sheet.wants(frame)) << frame;
}

TEST(ContactSheet, PutsFramesIntoRowsOfFour) {
  ContactSheet sheet(6);
  EXPECT_TRUE(sheet.empty());
  for (int i = 1; i <= 6; ++i) sheet.add(flat(640, 360, static_cast<uint8_t>(10 * i)));
  const Image image = sheet.image();
  ASSERT_EQ(image.width, 4 * 320 + 3 * 4);
  ASSERT_EQ(image.height, 2 * 180 + 4);
  ASSERT_EQ(image.rgb.size(), std::size_t{3} * image.width * image.height);
  EXPECT_EQ(red(image, 0, 0), 10);
  EXPECT_EQ(red(image, 319, 179), 10);
  EXPECT_EQ(red(image, 321, 90), 255) << "between two frames";
  EXPECT_EQ(red(image, 324 + 100, 90), 20);
  EXPECT_EQ(red(image, 3 * 324 + 319, 90), 40);
  EXPECT_EQ(red(image, 100, 184), 50);
  EXPECT_EQ(red(image, 324 + 319, 363), 60);
  EXPECT_EQ(red(image, 2 * 324 + 10, 200), 255) << "no seventh frame";
}

TEST(ContactSheet, ShrinksByMeansAndLeavesSmallFramesAsTheyAre) {
  Image stripes = flat(960, 300, 0);  // three columns become one
  for (std::size_t i = 0; i < stripes.rgb.size(); ++i) stripes.rgb[i] = (i / 3) % 3 == 0 ? 90 : 30;
  ContactSheet sheet(1), small(1);
  sheet.add(stripes);
  const Image shrunk = sheet.image();
  ASSERT_EQ(shrunk.width, 320);
  ASSERT_EQ(shrunk.height, 100);
  for (const uint8_t value : shrunk.rgb) ASSERT_EQ(value, 50);
  small.add(flat(64, 48, 7));
  EXPECT_EQ(small.image().rgb, flat(64, 48, 7).rgb);
}

}  // namespace
}  // namespace meniscus::io
