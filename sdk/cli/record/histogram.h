// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A histogram of non-negative values, for percentiles.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace meniscus::cli {

/// Counts of non-negative values, for percentiles of more values than could be stored.
class Histogram {
 public:
  /// Values from `bins · width` on are counted together, and treated as the largest of them.
  Histogram(double width, std::size_t bins) : width_(width), counts_(bins + 1, 0) {}

  void add(double value) {
    const double bin = std::min(std::max(value, 0.0) / width_, static_cast<double>(counts_.size() - 1));
    ++counts_[static_cast<std::size_t>(bin)];
    ++total_;
    largest_ = std::max(largest_, value);
  }

  uint64_t total() const { return total_; }
  double largest() const { return largest_; }

  /// The smallest value, within a bin's width, that a fraction `share` of all values does not exceed; 0
  /// without values.
  double percentile(double share) const {
    uint64_t seen = 0;
    for (std::size_t bin = 0; bin + 1 < counts_.size(); ++bin) {
      seen += counts_[bin];
      if (seen > 0 && static_cast<double>(seen) >= share * static_cast<double>(total_)) {
        return std::min(static_cast<double>(bin + 1) * width_, largest_);
      }
    }
    return largest_;
  }

 private:
  double width_;
  std::vector<uint64_t> counts_;
  uint64_t total_ = 0;
  double largest_ = 0;
};

}  // namespace meniscus::cli
