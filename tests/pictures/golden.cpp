// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Compares a picture with its stored reference, or renews the reference.
#include "tests/pictures/golden.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

#include <filesystem>

#include "tests/pictures/picture_difference.h"

namespace meniscus::tests {
namespace {

namespace fs = std::filesystem;

io::Image read_png(const fs::path& file) {
  io::Image image;
  int channels = 0;
  uint8_t* pixels = stbi_load(file.c_str(), &image.width, &image.height, &channels, 3);
  if (!pixels) return image;
  image.rgb.assign(pixels, pixels + std::size_t{3} * image.width * image.height);
  stbi_image_free(pixels);
  return image;
}

std::string put_aside(const std::string& name, const io::Image& image) {
  const fs::path folder = MENISCUS_DIFFERING_DIR;
  fs::create_directories(folder);
  io::write_png(folder / (name + ".png"), image);
  return "; see " + (folder / (name + ".png")).string();
}

}  // namespace

void expect_picture(const std::string& name, const io::Image& image) {
  const fs::path file = fs::path(MENISCUS_GOLDEN_DIR) / (name + ".png");
  if (const char* renew = std::getenv("MENISCUS_RENEW_PICTURES"); renew && *renew == '1') {
    io::write_png(file, image);
    return;
  }
  const io::Image golden = read_png(file);
  ASSERT_EQ(golden.width, image.width) << "there is no such " << file;
  ASSERT_EQ(golden.height, image.height) << file;
  const PictureDifference d = difference_of(golden, image);
  EXPECT_TRUE(d.acceptable()) << name << " looks different: blocks differ by " << d.worst_color
                              << " at most and " << d.mean_color << " on average, and structure is alike by "
                              << d.structure << put_aside(name, image);
}

}  // namespace meniscus::tests
