// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Draws the plots of a case.
#include "sdk/validation/chart.h"

#include <algorithm>
#include <array>
#include <limits>

#include "sdk/io/line_chart.h"
#include "sdk/validation/curves.h"

namespace meniscus::validation {
namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

/// All x of all curves, ascending, each once.
std::vector<double> common_x(const Plot& plot) {
  std::vector<double> x;
  for (const Curve& curve : plot.curves) x.insert(x.end(), curve.x.begin(), curve.x.end());
  std::sort(x.begin(), x.end());
  x.erase(std::unique(x.begin(), x.end()), x.end());
  return x;
}

/// Lines are interpolated; points stay where they are.
double drawn_at(const Curve& curve, double x) {
  if (x < curve.x.front() || x > curve.x.back()) return gap;
  const auto at = std::lower_bound(curve.x.begin(), curve.x.end(), x);
  if (*at == x) return curve.y[static_cast<std::size_t>(at - curve.x.begin())];
  return curve.points ? gap : value_at(curve, x);
}

}  // namespace

std::string drawing_of(const Plot& plot) {
  constexpr std::array line_colors{"#1f6fb4", "#2ca02c", "#9467bd", "#17becf"};
  constexpr std::array point_colors{"#d1622b", "#222222", "#888888"};
  io::LineChart chart{plot.title, plot.x_label, common_x(plot), {{plot.y_label, {}}}};
  std::size_t lines = 0, dots = 0;
  for (const Curve& curve : plot.curves) {
    const char* color =
        curve.points ? point_colors[dots++ % point_colors.size()] : line_colors[lines++ % line_colors.size()];
    io::ChartSeries series{curve.name, color, {}, curve.points};
    for (double x : chart.x) series.y.push_back(drawn_at(curve, x));
    chart.panels.front().series.push_back(std::move(series));
  }
  return io::to_svg(chart);
}

}  // namespace meniscus::validation
