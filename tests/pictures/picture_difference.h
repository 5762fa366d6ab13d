// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The visual difference of two pictures, instead of a comparison of bytes: another version of a driver rounds
// differently, and moves an edge slightly.
#pragma once

#include "sdk/io/png.h"

namespace meniscus::tests {

/// By blocks of 8 × 8 pixels, every fourth column and row. A just noticeable difference of colours is
/// about 2.
struct PictureDifference {
  double worst_color = 0;  ///< distance in CIE L*a*b* between the mean colours of a block, the largest
  double mean_color = 0;   ///< likewise, the mean
  /// Of lightness (Wang, Bovik, Sheikh & Simoncelli 2004, Image Quality Assessment): 1 where edges and their
  /// contrast are the same; the mean over all blocks.
  double structure = 1;

  /// What no one sees.
  bool acceptable() const { return worst_color <= 3 && mean_color <= 0.5 && structure >= 0.985; }
};

/// Of pictures of equal size, 8 × 8 pixels or more.
PictureDifference difference_of(const io::Image& a, const io::Image& b);

}  // namespace meniscus::tests
