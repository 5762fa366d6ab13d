// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Chooses a coarser picture while things move.
#pragma once

#include <algorithm>
#include <cmath>

namespace meniscus::viewer {

/// The resolution of pictures while things move, so that they come fast enough. At rest the resolution is
/// full.
class Draft {
 public:
  /// Fraction of the width and height, in eighths, so that it does not change all the time.
  float share() const { return share_; }

  /// Records that a picture with `share` of the width and height took this long.
  void took(double ms, float share) {
    const double all = ms / double{share * share};  // estimate for full resolution
    const double wanted = std::sqrt(good_ms / std::max(all, 1e-3));
    const float eighths = std::clamp(std::floor(8 * static_cast<float>(wanted)), 2.0f, 8.0f) / 8;
    // Becomes coarser at once, but finer only with a clear reserve.
    if (eighths < share_ || wanted > 1.3 * double{share_} + 0.125) share_ = eighths;
  }

 private:
  static constexpr double good_ms = 50;
  float share_ = 1;
};

}  // namespace meniscus::viewer
