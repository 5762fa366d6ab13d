// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Shrinks frames and puts them on a contact sheet.
#include "sdk/io/contact_sheet.h"

#include <algorithm>

namespace meniscus::io {
namespace {

constexpr int most = 12, columns = 4, widest = 320, gap = 4;
constexpr uint8_t paper = 255;

/// Each pixel is the mean of those that it replaces.
Image shrunk(const Image& image, int width) {
  const int height = std::max(1, image.height * width / image.width);
  Image small{width, height, {}};
  const auto first = [](int i, int from, int to) { return static_cast<int>(int64_t{i} * from / to); };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int x0 = first(x, image.width, width), x1 = std::max(first(x + 1, image.width, width), x0 + 1);
      const int y0 = first(y, image.height, height),
                y1 = std::max(first(y + 1, image.height, height), y0 + 1);
      for (int k = 0; k < 3; ++k) {
        int sum = 0;
        for (int j = y0; j < y1; ++j) {
          for (int i = x0; i < x1; ++i) sum += image.rgb[3 * (std::size_t{1} * j * image.width + i) + k];
        }
        const int count = (x1 - x0) * (y1 - y0);
        small.rgb.push_back(static_cast<uint8_t>((sum + count / 2) / count));
      }
    }
  }
  return small;
}

}  // namespace

ContactSheet::ContactSheet(int frames) : frames_(frames), tiles_(std::min(frames, most)) {}

bool ContactSheet::wants(int frame) const {
  return int64_t{frame} * tiles_ / frames_ != int64_t{frame - 1} * tiles_ / frames_;
}

void ContactSheet::add(const Image& image) {
  added_.push_back(shrunk(image, std::min(image.width, widest)));
}

Image ContactSheet::image() const {
  const int count = static_cast<int>(added_.size()), across = std::min(count, columns),
            down = (count + columns - 1) / columns;
  const int width = added_[0].width, height = added_[0].height;
  Image sheet{across * (width + gap) - gap, down * (height + gap) - gap, {}};
  sheet.rgb.assign(std::size_t{3} * sheet.width * sheet.height, paper);
  for (int i = 0; i < count; ++i) {
    const int left = i % columns * (width + gap), top = i / columns * (height + gap);
    for (int y = 0; y < height; ++y) {
      std::copy_n(added_[i].rgb.begin() + std::ptrdiff_t{3} * y * width, 3 * width,
                  sheet.rgb.begin() + std::ptrdiff_t{3} * ((top + y) * std::ptrdiff_t{sheet.width} + left));
    }
  }
  return sheet;
}

}  // namespace meniscus::io
