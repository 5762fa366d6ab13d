// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Measures streaks in normals.
#include "sdk/cli/evidence/streaks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meniscus::cli {
namespace {

struct Sum {
  double squares = 0;
  std::size_t count = 0;

  void add(const NormalPicture& p, int x, int y, int dx, int dy, float threshold) {
    const int reach = std::max(std::abs(dx), std::abs(dy));
    if (x < reach || y < reach || x + reach >= p.width || y + reach >= p.height) return;
    const auto at = [&](int side) -> const std::array<float, 4>& {
      return p.pixels[static_cast<std::size_t>(y + side * dy) * p.width + (x + side * dx)];
    };
    const auto &before = at(-1), &here = at(0), &after = at(1);
    for (const auto* pixel : {&before, &here, &after}) {
      if ((*pixel)[3] <= 0 || std::abs((*pixel)[3] - here[3]) > threshold) return;
    }
    for (int k = 0; k < 3; ++k) {
      const double bend = double{before[k]} - 2 * double{here[k]} + double{after[k]};
      squares += bend * bend;
    }
    ++count;
  }
  double rms() const {
    return count ? std::sqrt(squares / static_cast<double>(count)) * 180 / std::numbers::pi : 0;
  }
};

}  // namespace

Roughness roughness_of(const NormalPicture& picture, float threshold) {
  Sum axes, between;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      axes.add(picture, x, y, 5, 0, threshold);
      axes.add(picture, x, y, 0, 5, threshold);
      for (const int side : {-1, 1}) {
        between.add(picture, x, y, 3 * side, 4, threshold);
        between.add(picture, x, y, 4 * side, 3, threshold);
      }
    }
  }
  return {axes.rms(), between.rms(), axes.count + between.count};
}

}  // namespace meniscus::cli
