// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Measures pictures.
#include "tests/pictures/picture_metrics.h"

#include <algorithm>
#include <cmath>

namespace meniscus::tests {
namespace {

double luma(const uint8_t* p) {
  return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
}

/// One number per pixel; beyond the picture there is what lies at its edge.
template <class T>
struct Plane {
  int width, height;
  std::vector<T> values;

  T at(int x, int y) const {
    x = std::clamp(x, 0, width - 1);
    y = std::clamp(y, 0, height - 1);
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

template <class T, class Value>
Plane<T> plane_of(int width, int height, const Value& value) {
  Plane<T> plane{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) plane.values.push_back(static_cast<T>(value(x, y)));
  }
  return plane;
}

Plane<double> lumas(const io::Image& image) {
  Plane<double> plane{image.width, image.height, {}};
  for (std::size_t k = 0; k < image.rgb.size(); k += 3) plane.values.push_back(luma(&image.rgb[k]));
  return plane;
}

/// Least or greatest over 7 × 7 pixels.
Plane<char> spread(const Plane<char>& mask, bool greatest) {
  return plane_of<char>(mask.width, mask.height, [&](int x, int y) {
    for (int j = -3; j <= 3; ++j) {
      for (int i = -3; i <= 3; ++i) {
        if ((mask.at(x + i, y + j) != 0) == greatest) return greatest;
      }
    }
    return !greatest;
  });
}

double edge_of(const Plane<double>& light, const Plane<char>& fluid) {
  const Plane<char> body = spread(spread(fluid, false), true);
  double sum = 0;
  int count = 0;
  for (int y = 1; y + 1 < light.height; ++y) {
    for (int x = 1; x + 1 < light.width; ++x) {
      if (!body.at(x, y) ||
          (body.at(x - 1, y) && body.at(x + 1, y) && body.at(x, y - 1) && body.at(x, y + 1)))
        continue;
      sum +=
          0.5 * std::hypot(light.at(x + 1, y) - light.at(x - 1, y), light.at(x, y + 1) - light.at(x, y - 1));
      ++count;
    }
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace

PictureMetrics metrics_of(const io::Image& picture, const io::Image& bare,
                          std::span<const std::array<float, 4>> surface) {
  const Plane<double> light = lumas(picture), without = lumas(bare);
  const auto index = [&](int x, int y) { return static_cast<std::size_t>(y) * picture.width + x; };
  const Plane<char> fluid = plane_of<char>(picture.width, picture.height,
                                           [&](int x, int y) { return surface[index(x, y)][3] > 0; });
  PictureMetrics m;
  int wet = 0;
  for (int y = 1; y + 1 < picture.height; ++y) {
    for (int x = 1; x + 1 < picture.width; ++x) {
      if (!fluid.at(x, y)) continue;
      m.noise += std::abs(4 * light.at(x, y) - light.at(x - 1, y) - light.at(x + 1, y) - light.at(x, y - 1) -
                          light.at(x, y + 1));
      ++wet;
    }
  }
  m.noise /= std::max(wet, 1);
  for (std::size_t i = 0; i < light.values.size(); ++i) {
    const uint8_t* p = &picture.rgb[3 * i];
    m.brightness += light.values[i];
    m.foam_cover += light.values[i] > without.values[i] + 16;
    m.dark_blue += light.values[i] < 85 && p[2] > p[0] + 80;
  }
  const auto pixels = static_cast<double>(light.values.size());
  for (double* sum : {&m.brightness, &m.foam_cover, &m.dark_blue}) *sum /= pixels;
  m.edge = edge_of(light, fluid);
  return m;
}

Flicker flicker_of(const io::Image& a, const io::Image& b) {
  std::vector<double> differences;
  for (std::size_t k = 0; k < a.rgb.size(); k += 3)
    differences.push_back(std::abs(luma(&a.rgb[k]) - luma(&b.rgb[k])) / 2.55);
  Flicker flicker;
  for (const double d : differences) flicker.mean += d / static_cast<double>(differences.size());
  const auto place = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() * 99 / 100);
  std::nth_element(differences.begin(), place, differences.end());
  flicker.highest_hundredth = *place;
  return flicker;
}

}  // namespace meniscus::tests
