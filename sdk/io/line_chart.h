// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Line charts as SVG documents.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace meniscus::io {

struct ChartSeries {
  std::string name;   ///< in the legend
  std::string color;  ///< as SVG writes it
  std::vector<double> y;
  bool points = false;  ///< dots in place of a line
};

/// A frame with its own vertical axis, which contains 0.
struct ChartPanel {
  std::string y_label;
  std::vector<ChartSeries> series;
};

/// Panels one above the other over a common horizontal axis.
struct LineChart {
  std::string title;
  std::string x_label;
  std::vector<double> x;
  std::vector<ChartPanel> panels;
};

/// A standalone SVG document. Points that are not finite are gaps. Throws Error(invalid_argument) if the
/// length of a series differs from that of x.
std::string to_svg(const LineChart& chart);

/// About `count` round numbers with a step of 1, 2 or 5 times a power of ten. They go from the one at or
/// below `low` to the one at or above `high`. Needs low < high.
std::vector<double> round_ticks(double low, double high, int count);

/// The density error of a run.
struct DensityHistory {
  std::string title;
  std::span<const double> times;  ///< s
  std::span<const double> mean;   ///< mean of max(C, 0), a fraction
  std::span<const double> max;    ///< largest C, a fraction
};

/// Writes mean and largest density error in percent over time. Throws Error(io).
void write_density_svg(const std::filesystem::path& path, const DensityHistory& history);

}  // namespace meniscus::io
