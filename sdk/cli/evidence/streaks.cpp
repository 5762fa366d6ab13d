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
    if (x + dx < 0 || x + dx >= p.width || y + dy >= p.height) return;
    const auto at = [&](int column, int row) -> const std::array<float, 4>& {
      return p.pixels[static_cast<std::size_t>(row) * p.width + column];
    };
    const auto &a = at(x, y), &b = at(x + dx, y + dy);
    if (a[3] <= 0 || b[3] <= 0 || std::abs(a[3] - b[3]) > threshold) return;
    const double cosine = double{a[0]} * b[0] + double{a[1]} * b[1] + double{a[2]} * b[2];
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
    squares += angle * angle;
    ++count;
  }
  double rms() const { return count ? std::sqrt(squares / static_cast<double>(count)) : 0; }
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
