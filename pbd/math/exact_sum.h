// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Sums of floating-point numbers without rounding, which have the same bits in any order.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "pbd/device/base/qualifiers.h"

namespace meniscus::pbd {

/// An integer of 192 bits, in two's complement, of units of 2⁻⁹⁶. A number below 2⁶⁰ is added exactly, but
/// for what it has below one unit. So 2³⁵ of them have room. Anything else, such as NaN, makes the sum NaN.
struct ExactSum {
  uint64_t low = 0, middle = 0, high = 0;
  uint64_t refused = 0;  ///< how many were not numbers below 2⁶⁰

  MENISCUS_HD static ExactSum of(double x) {
    ExactSum sum;
    const double size = fabs(x);
    if (!(size < 0x1p60)) {
      sum.refused = 1;
      return sum;
    }
    const double whole = floor(size), scaled = (size - whole) * 0x1p48, upper = floor(scaled);
    const auto above = static_cast<uint64_t>(whole), fraction = static_cast<uint64_t>(upper);
    sum.low = fraction << 48 | static_cast<uint64_t>((scaled - upper) * 0x1p48);
    sum.middle = above << 32 | fraction >> 16;
    sum.high = above >> 32;
    return x < 0 ? sum.negative() : sum;
  }

  MENISCUS_HD ExactSum operator+(const ExactSum& other) const {
    ExactSum sum;
    sum.low = low + other.low;
    const uint64_t carry = sum.low < low;
    sum.middle = middle + other.middle;
    const uint64_t overflow = sum.middle < middle;
    sum.middle += carry;
    sum.high = high + other.high + overflow + (sum.middle < carry);
    sum.refused = refused + other.refused;
    return sum;
  }

  double value() const {
    if (refused) return std::nan("");
    if (high >> 63) return -negative().value();
    return 0x1p32 * static_cast<double>(high) + 0x1p-32 * static_cast<double>(middle) +
           0x1p-96 * static_cast<double>(low);
  }

  /// Parts that may be added up one by one, over up to 2³² sums.
  static constexpr int parts = 7;
  std::array<uint64_t, parts> split() const {
    constexpr uint64_t half = 0xffffffff;
    return {low & half, low >> 32, middle & half, middle >> 32, high & half, high >> 32, refused};
  }
  /// The sum of which these are the parts, added up.
  static ExactSum joined(const uint64_t* part) {
    std::array<uint64_t, 6> digits{};
    uint64_t carry = 0;
    for (size_t k = 0; k < digits.size(); ++k) {
      carry += part[k];
      digits[k] = carry & 0xffffffff;
      carry >>= 32;
    }
    return {digits[0] | digits[1] << 32, digits[2] | digits[3] << 32, digits[4] | digits[5] << 32, part[6]};
  }

 private:
  MENISCUS_HD ExactSum negative() const {
    ExactSum n{~low + 1, ~middle, ~high, refused};
    n.middle += n.low == 0;
    n.high += n.low == 0 && n.middle == 0;
    return n;
  }
};

}  // namespace meniscus::pbd
