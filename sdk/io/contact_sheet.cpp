// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Shrinks frames, chooses among them by motion, and puts them on a contact sheet.
#include "sdk/io/contact_sheet.h"

#include <algorithm>
#include <cstdlib>

namespace meniscus::io {
namespace {

constexpr int most = 12, most_candidates = 24, columns = 4, widest = 320, gap = 4;
constexpr double even_part = 0.2;  // of the way between frames, so that a rest gets a shot as well
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

/// Sum over the values of all pixels.
double difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
  return sum;
}

/// From the first image to each, 0 to 1.
std::vector<double> ways_to(const std::vector<Image>& images) {
  std::vector<double> ways(images.size());
  for (std::size_t i = 1; i < images.size(); ++i)
    ways[i] = ways[i - 1] + difference(images[i], images[i - 1]);
  const double all = ways.back(), last = static_cast<double>(images.size() - 1);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const double even = static_cast<double>(i) / last;
    ways[i] = all > 0 ? (1 - even_part) * ways[i] / all + even_part * even : even;
  }
  return ways;
}

/// The images at equal ways along the motion, the first and the last among them.
std::vector<std::size_t> shots_of(const std::vector<Image>& images) {
  const std::size_t count = std::min<std::size_t>(images.size(), most);
  std::vector<std::size_t> shots{0};
  if (count < 2) return shots;
  const std::vector<double> ways = ways_to(images);
  for (std::size_t k = 1; k < count; ++k) {
    const double way = static_cast<double>(k) / static_cast<double>(count - 1);
    const auto reached = std::lower_bound(ways.begin(), ways.end(), way - 1e-9);
    const auto next = static_cast<std::size_t>(reached - ways.begin());
    // Each image once, and enough left for the rest.
    shots.push_back(std::clamp(next, shots.back() + 1, images.size() - count + k));
  }
  return shots;
}

}  // namespace

ContactSheet::ContactSheet(int frames) : frames_(frames), candidates_(std::min(frames, most_candidates)) {}

bool ContactSheet::wants(int frame) const {
  return int64_t{frame} * candidates_ / frames_ != int64_t{frame - 1} * candidates_ / frames_;
}

void ContactSheet::add(const Image& image) {
  added_.push_back(shrunk(image, std::min(image.width, widest)));
}

Image ContactSheet::image() const {
  const std::vector<std::size_t> shots = shots_of(added_);
  const int count = static_cast<int>(shots.size()), across = std::min(count, columns),
            down = (count + columns - 1) / columns;
  const int width = added_[0].width, height = added_[0].height;
  Image sheet{across * (width + gap) - gap, down * (height + gap) - gap, {}};
  sheet.rgb.assign(std::size_t{3} * sheet.width * sheet.height, paper);
  for (int i = 0; i < count; ++i) {
    const int left = i % columns * (width + gap), top = i / columns * (height + gap);
    for (int y = 0; y < height; ++y) {
      std::copy_n(added_[shots[i]].rgb.begin() + std::ptrdiff_t{3} * y * width, 3 * width,
                  sheet.rgb.begin() + std::ptrdiff_t{3} * ((top + y) * std::ptrdiff_t{sheet.width} + left));
    }
  }
  return sheet;
}

}  // namespace meniscus::io
