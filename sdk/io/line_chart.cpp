// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes line charts as SVG.
#include "sdk/io/line_chart.h"

#include <spdlog/fmt/fmt.h>

#include <meniscus/error.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "sdk/files/output_file.h"
#include "sdk/io/plain_text.h"

namespace meniscus::io {
namespace {

// Pixels of the drawing.
constexpr double width = 920, panel_height = 210, panel_gap = 26;
constexpr double left = 84, right = 28, top = 64, bottom = 58;

struct Axis {
  std::vector<double> ticks;
  double start = 0, end = 0;  // in pixels, of the first and the last tick

  double at(double value) const {
    return start + (end - start) * (value - ticks.front()) / (ticks.back() - ticks.front());
  }
};

/// The interval of all finite values and 0.
std::array<double, 2> extent(const ChartPanel& panel) {
  double low = 0, high = 0;
  for (const ChartSeries& series : panel.series) {
    for (const double v : series.y) {
      if (!std::isfinite(v)) continue;
      low = std::min(low, v);
      high = std::max(high, v);
    }
  }
  return {low, high > low ? high : low + 1};
}

Axis horizontal_axis(const LineChart& chart) {
  Axis axis{{}, left, width - right};
  const double low = chart.x.empty() ? 0 : std::min(chart.x.front(), 0.0);
  const double high = chart.x.empty() ? 1 : chart.x.back();
  axis.ticks = round_ticks(low, high > low ? high : low + 1, 8);
  return axis;
}

Axis vertical_axis(const ChartPanel& panel, double panel_top) {
  const auto [low, high] = extent(panel);
  return {round_ticks(low, high, 4), panel_top + panel_height, panel_top};
}

std::string text(double x, double y, const char* anchor, const std::string& content, const char* more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                     xml_escaped(content));
}

std::string line(double x1, double y1, double x2, double y2, const char* color) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1,
                     y1, x2, y2, color);
}

std::string dots(const ChartSeries& series, const std::vector<double>& x, const Axis& across,
                 const Axis& up) {
  std::string svg;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(series.y[i])) continue;
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.6\" fill=\"{}\"/>\n", across.at(x[i]),
                       up.at(series.y[i]), series.color);
  }
  return svg;
}

/// The polylines between gaps, each with a tinted area from it to 0.
std::string curve(const ChartSeries& series, const std::vector<double>& x, const Axis& across,
                  const Axis& up) {
  std::string svg, points;
  double first = 0, last = 0;
  const auto finish = [&] {
    if (points.empty()) return;
    svg +=
        fmt::format("<polygon points=\"{:.1f},{:.1f} {}{:.1f},{:.1f}\" fill=\"{}\" fill-opacity=\"0.12\"/>\n",
                    first, up.at(0), points, last, up.at(0), series.color);
    svg += fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\" "
        "stroke-linejoin=\"round\"/>\n",
        points, series.color);
    points.clear();
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(series.y[i])) {
      finish();
      continue;
    }
    last = across.at(x[i]);
    if (points.empty()) first = last;
    points += fmt::format("{:.1f},{:.1f} ", last, up.at(series.y[i]));
  }
  finish();
  return svg;
}

std::string legend(const ChartPanel& panel, double panel_top) {
  std::string svg;
  double y = panel_top + 20;
  for (const ChartSeries& series : panel.series) {
    svg += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"3\"/>\n",
        width - right - 36, y - 4, width - right - 12, y - 4, series.color);
    svg += text(width - right - 44, y, "end", series.name, " class=\"halo\"");
    y += 20;
  }
  return svg;
}

std::string grid(const ChartPanel& panel, const Axis& across, const Axis& up) {
  std::string svg;
  for (const double tick : across.ticks)
    svg += line(across.at(tick), up.start, across.at(tick), up.end, "#eef0f3");
  for (const double tick : up.ticks) {
    svg += line(left, up.at(tick), width - right, up.at(tick), tick == 0 ? "#8a93a0" : "#e1e5ea");
    svg += text(left - 10, up.at(tick) + 4.5, "end", fmt::format("{:.6g}", tick));
  }
  const double middle = (up.start + up.end) / 2;
  svg += text(24, middle, "middle", panel.y_label,
              fmt::format(" transform=\"rotate(-90 24 {:.1f})\" class=\"label\"", middle).c_str());
  return svg;
}

std::string panel_svg(const LineChart& chart, const ChartPanel& panel, const Axis& across, double panel_top) {
  const Axis up = vertical_axis(panel, panel_top);
  std::string svg = grid(panel, across, up);
  for (const ChartSeries& series : panel.series)
    svg += series.points ? dots(series, chart.x, across, up) : curve(series, chart.x, across, up);
  return svg + legend(panel, panel_top);
}

std::string horizontal_labels(const LineChart& chart, const Axis& across, double base) {
  std::string svg;
  for (const double tick : across.ticks) {
    svg += text(across.at(tick), base + 20, "middle", fmt::format("{:.6g}", tick));
  }
  return svg + text((left + width - right) / 2, base + 44, "middle", chart.x_label, " class=\"label\"");
}

void check_lengths(const LineChart& chart) {
  for (const ChartPanel& panel : chart.panels) {
    for (const ChartSeries& series : panel.series) {
      if (series.y.size() == chart.x.size()) continue;
      throw Error(ErrorCode::invalid_argument, "series '" + series.name + "' has " +
                                                   std::to_string(series.y.size()) + " values, but x has " +
                                                   std::to_string(chart.x.size()));
    }
  }
}

std::vector<double> in_percent(std::span<const double> fractions) {
  std::vector<double> percent(fractions.size());
  std::transform(fractions.begin(), fractions.end(), percent.begin(),
                 [](double c) { return 100 * std::max(c, 0.0); });
  return percent;
}

}  // namespace

std::vector<double> round_ticks(double low, double high, int count) {
  const double rough = (high - low) / count;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= rough * (1 - 1e-9)) step = factor * power;
  }
  const double first = std::floor(low / step + 1e-9), last = std::ceil(high / step - 1e-9);
  std::vector<double> ticks;
  for (double k = first; k <= last; ++k) ticks.push_back(k * step);
  return ticks;
}

std::string to_svg(const LineChart& chart) {
  check_lengths(chart);
  const double panels = static_cast<double>(chart.panels.size());
  const double height = top + panels * panel_height + (panels - 1) * panel_gap + bottom;
  const Axis across = horizontal_axis(chart);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" "
      "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size=\"13\" fill=\"#39424e\">\n"
      "<style>.title{{font-size:19px;font-weight:bold;fill:#1d242c}} .label{{font-size:14px}} "
      ".halo{{paint-order:stroke;stroke:#ffffff;stroke-width:4px}}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
      width, height);
  svg += text(left, 38, "start", chart.title, " class=\"title\"");
  double panel_top = top;
  for (const ChartPanel& panel : chart.panels) {
    svg += panel_svg(chart, panel, across, panel_top);
    panel_top += panel_height + panel_gap;
  }
  return svg + horizontal_labels(chart, across, panel_top - panel_gap) + "</svg>\n";
}

void write_density_svg(const std::filesystem::path& path, const DensityHistory& history) {
  const LineChart chart{
      history.title,
      "time (s)",
      {history.times.begin(), history.times.end()},
      {{"density error (%)", {{"mean over the particles", "#1f6fb4", in_percent(history.mean)}}},
       {"density error (%)", {{"largest of the particles", "#d1622b", in_percent(history.max)}}}}};
  OutputFile file(path);
  file.write(to_svg(chart));
  file.commit();
}

}  // namespace meniscus::io
