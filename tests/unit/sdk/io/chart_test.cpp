// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of line charts.
#include <gtest/gtest.h>
#include <meniscus/error.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "sdk/io/line_chart.h"

namespace meniscus::io {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

LineChart one_line(std::vector<double> x, std::vector<double> y) {
  return {"a < b", "time (s)", std::move(x), {{"error (%)", {{"mean", "#123456", std::move(y)}}}}};
}

/// The points of the first polyline.
std::vector<std::pair<double, double>> points(const std::string& svg) {
  const std::string before = "<polyline points=\"";
  const std::size_t start = svg.find(before) + before.size();
  std::istringstream list(svg.substr(start, svg.find('"', start) - start));
  std::vector<std::pair<double, double>> result;
  double x = 0, y = 0;
  char comma = 0;
  while (list >> x >> comma >> y) result.emplace_back(x, y);
  return result;
}

TEST(RoundTicks, AreRoundAndHoldTheRange) {
  EXPECT_EQ(round_ticks(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(round_ticks(0, 4, 8), (std::vector<double>{0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4}));
  EXPECT_EQ(round_ticks(0, 730, 4), (std::vector<double>{0, 200, 400, 600, 800}));
  for (const double high : {1e-7, 3.3e-4, 0.0999, 1.0, 7.77, 12345.0}) {
    const std::vector<double> ticks = round_ticks(0, high, 4);
    EXPECT_EQ(ticks.front(), 0);
    EXPECT_GE(ticks.back(), high * (1 - 1e-6));
    EXPECT_LT(ticks[ticks.size() - 2], high);
    EXPECT_LE(ticks.size(), 6u) << high;
  }
}

TEST(LineChart, DrawsTheDataToScale) {
  const auto drawn = points(to_svg(one_line({0, 1, 2}, {0, 1, 2})));
  ASSERT_EQ(drawn.size(), 3u);
  EXPECT_NEAR(drawn[1].first, (drawn[0].first + drawn[2].first) / 2, 0.11);
  EXPECT_NEAR(drawn[1].second, (drawn[0].second + drawn[2].second) / 2, 0.11);
  EXPECT_LT(drawn[2].second, drawn[0].second) << "larger values stand higher";
}

TEST(LineChart, DrawsBelowZeroAndDots) {
  const auto drawn = points(to_svg(one_line({0, 1, 2}, {-1, 0, 1})));
  ASSERT_EQ(drawn.size(), 3u);
  EXPECT_NEAR(drawn[1].second, (drawn[0].second + drawn[2].second) / 2, 0.11);
  EXPECT_GT(drawn[0].second, drawn[1].second);
  LineChart chart = one_line({0, 1, 2}, {1, std::numeric_limits<double>::quiet_NaN(), 2});
  chart.panels.front().series.front().points = true;
  const std::string svg = to_svg(chart);
  EXPECT_EQ(count(svg, "<circle"), 2u);
  EXPECT_EQ(count(svg, "<polyline"), 0u);
}

TEST(LineChart, HasLabelsAndEscapesThem) {
  const std::string svg = to_svg(one_line({0, 1}, {3, 4}));
  EXPECT_EQ(svg.rfind("<svg xmlns=", 0), 0u);
  EXPECT_NE(svg.find("</svg>\n"), std::string::npos);
  for (const char* text : {">a &lt; b<", ">time (s)<", ">error (%)<", ">mean<"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
}

TEST(LineChart, LeavesAGapWhereAValueIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string svg = to_svg(one_line({0, 1, 2, 3, 4}, {1, 2, nan, 2, 1}));
  EXPECT_EQ(count(svg, "<polyline"), 2u);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(LineChart, StandsWithoutData) {
  const std::string svg = to_svg(one_line({}, {}));
  EXPECT_EQ(count(svg, "<polyline"), 0u);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(LineChart, RefusesSeriesOfAnotherLength) {
  try {
    to_svg(one_line({0, 1, 2}, {0, 1}));
    FAIL() << "a short series was drawn";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    EXPECT_NE(std::string(error.what()).find("'mean' has 2"), std::string::npos);
  }
}

TEST(DensityChart, IsAFileInPercent) {
  const auto path =
      std::filesystem::temp_directory_path() / ("meniscus_chart_" + std::to_string(getpid()) + ".svg");
  const std::vector<double> times{0.1, 0.2}, mean{0.002, 0.004}, max{0.02, 0.08};
  write_density_svg(path, {"run", times, mean, max});
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  std::filesystem::remove(path);
  const std::string svg = text.str();
  EXPECT_EQ(count(svg, "<polyline"), 2u);
  EXPECT_NE(svg.find(">0.4<"), std::string::npos) << "the top of the axis of the mean, in percent";
  EXPECT_NE(svg.find(">8<"), std::string::npos) << "the top of the axis of the maximum, in percent";
}

}  // namespace
}  // namespace meniscus::io
