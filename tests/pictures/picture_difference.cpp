// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The difference of two pictures as an eye sees it.
#include "tests/pictures/picture_difference.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace meniscus::tests {
namespace {

constexpr int block = 8, stride = 4;

using Lab = std::array<double, 3>;

double linear(uint8_t value) {
  const double c = value / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double cube_root(double t) {
  constexpr double d = 6.0 / 29;
  return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29;
}

/// CIE 1976, from sRGB; white is D65.
Lab lab_of(const uint8_t* rgb) {
  const double r = linear(rgb[0]), g = linear(rgb[1]), b = linear(rgb[2]);
  const double x = cube_root((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505),
               y = cube_root(0.2126 * r + 0.7152 * g + 0.0722 * b),
               z = cube_root((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// What a block of two pictures sums up to.
struct Block {
  Lab a{}, b{};                   // means
  double aa = 0, bb = 0, ab = 0;  // of squares and products of L*
  int count = 0;

  void add(const Lab& p, const Lab& q) {
    for (int k = 0; k < 3; ++k) {
      a[k] += p[k];
      b[k] += q[k];
    }
    aa += p[0] * p[0];
    bb += q[0] * q[0];
    ab += p[0] * q[0];
    ++count;
  }
  void finish() {
    for (int k = 0; k < 3; ++k) {
      a[k] /= count;
      b[k] /= count;
    }
    for (double* sum : {&aa, &bb, &ab}) *sum /= count;
  }
  double color() const { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }
  double structure() const {
    // The constants of the paper for L* from 0 to 100.
    constexpr double c1 = 1, c2 = 9;
    const double va = aa - a[0] * a[0], vb = bb - b[0] * b[0], covariance = ab - a[0] * b[0];
    return (2 * a[0] * b[0] + c1) * (2 * covariance + c2) /
           ((a[0] * a[0] + b[0] * b[0] + c1) * (va + vb + c2));
  }
};

}  // namespace

PictureDifference difference_of(const io::Image& a, const io::Image& b) {
  PictureDifference difference;
  double colors = 0, structures = 0;
  int blocks = 0;
  for (int y = 0; y + block <= a.height; y += stride) {
    for (int x = 0; x + block <= a.width; x += stride) {
      Block sums;
      for (int j = y; j < y + block; ++j) {
        for (int i = x; i < x + block; ++i) {
          const std::size_t k = std::size_t{3} * (std::size_t{1} * j * a.width + i);
          sums.add(lab_of(&a.rgb[k]), lab_of(&b.rgb[k]));
        }
      }
      sums.finish();
      difference.worst_color = std::max(difference.worst_color, sums.color());
      colors += sums.color();
      structures += sums.structure();
      ++blocks;
    }
  }
  difference.mean_color = colors / blocks;
  difference.structure = structures / blocks;
  return difference;
}

}  // namespace meniscus::tests
