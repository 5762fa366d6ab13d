// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Figures of a picture with foam, by which two renderers are compared. Luma is 0.299 R + 0.587 G + 0.114 B, 0
// to 255.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sdk/io/png.h"

namespace meniscus::tests {

struct PictureMetrics {
  /// Mean |4 L − Lₗ − Lᵣ − Lₐ − Lᵦ| of luma, over pixels that show fluid.
  double noise = 0;
  /// Mean luma of the picture.
  double brightness = 0;
  /// Fraction of pixels whose luma foam raises by more than 16.
  double foam_cover = 0;
  /// Fraction of pixels with luma below 85 whose blue exceeds red by more than 80.
  double dark_blue = 0;
  /// Mean length of luma's gradient along the outline of the fluid, without drops of less than 7 pixels.
  double edge = 0;
};

/// `bare` is the same picture without foam. `surface` is of Renderer::fluid_normals.
PictureMetrics metrics_of(const io::Image& picture, const io::Image& bare,
                          std::span<const std::array<float, 4>> surface);

/// Differences of luma between two pictures, as percentages of white.
struct Flicker {
  double mean = 0, highest_hundredth = 0;  ///< the latter: at the 99th percentile
};
Flicker flicker_of(const io::Image& a, const io::Image& b);

}  // namespace meniscus::tests
