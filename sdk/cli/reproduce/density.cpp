// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Figure 4: density over the bunny drop, PCISPH at 10 × 4 against PBF at 4 × 10.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <limits>

#include "sdk/cli/reproduce/parts.h"

namespace meniscus::cli::pbf {
namespace {

constexpr const char* colors[] = {"#1f6fb4", "#d1622b"};

/// In kg/m³ above the rest density, and gaps where a run ended early.
std::vector<double> above_rest(const std::vector<double>& errors, double rest_density, std::size_t length) {
  std::vector<double> above(length, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < errors.size(); ++k) above[k] = rest_density * std::max(errors[k], 0.0);
  return above;
}

io::LineChart chart_of(const std::vector<RunFigures>& runs, double rest_density) {
  io::LineChart chart{"Bunny drop: density above rest, which is the line at 0", "time (s)", {}, {}};
  for (const RunFigures& run : runs) {
    if (run.time.size() > chart.x.size()) chart.x = run.time;
  }
  chart.panels = {{"mean (kg/m³)", {}}, {"largest (kg/m³)", {}}};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const std::string color = colors[k % std::size(colors)];
    const std::size_t length = chart.x.size();
    chart.panels[0].series.push_back(
        {runs[k].name, color, above_rest(runs[k].error_mean, rest_density, length)});
    chart.panels[1].series.push_back(
        {runs[k].name, color, above_rest(runs[k].error_max, rest_density, length)});
  }
  return chart;
}

io::Report::Cells row_of(const RunFigures& run, double rest) {
  return {run.name,
          fmt::format("{:.1f}", mean_of(run.substeps)),
          fmt::format("{:.1f}", mean_of(run.iterations)),
          fmt::format("{:.2f}", rest * (1 + mean_of(run.error_mean))),
          fmt::format("{:.1f}", rest * (1 + mean_of(run.density_mean))),
          fmt::format("{:.1f}", rest * (1 + mean_of(run.error_max))),
          fmt::format("{:.1f}", rest * (1 + largest_of(run.error_max))),
          fmt::format("{:.3g}", median_of(run.ms)),
          run.failure.empty() ? "" : run.failure};
}

}  // namespace

bool add_density(const Context& context) {
  const PaperScene found = context.scene("bunny_drop");
  const double rest = double{found.scene.fluids.front().rest_density};
  struct Setting {
    const char* name;
    Scene scene;
  };
  const std::vector<Setting> settings{{"PBF, 4 × 10", with_setting(found.scene, 4, 10)},
                                      {"PCISPH, 10 × 4", with_pcisph(found.scene, 10, 4)}};
  std::vector<RunFigures> runs;
  const bool done = for_each_until_stopped(
      settings, [&](const Setting& s) { runs.push_back(context.run(s.name, s.scene)); });

  io::Report& report = context.report;
  report.heading("Figure 4: density over the bunny drop");
  report.paragraph(
      "Both methods have at most 40 iterations a frame. PCISPH ends them once no particle is above 1 %. The "
      "mean counts max(ρ, ρ₀) of each particle. The plain mean "
      "is "
      "lower, since particles at the surface lack neighbours. PCISPH here takes no artificial pressure.");
  if (!found.stand_in.empty()) report.paragraph(found.stand_in);
  if (!runs.empty() && !runs.front().time.empty()) report.chart("density", chart_of(runs, rest));
  std::vector<io::Report::Cells> rows;
  for (const RunFigures& run : runs) rows.push_back(row_of(run, rest));
  report.table({"method", "substeps made", "iterations made", "mean density, kg/m³", "plain mean",
                "largest, mean over frames", "largest", "ms a frame", "failure"},
               rows);
  for (const RunFigures& run : runs)
    report.figures["density"].push_back({{"name", run.name},
                                         {"time_s", run.time},
                                         {"error_mean", run.error_mean},
                                         {"error_max", run.error_max},
                                         {"density_mean", run.density_mean},
                                         {"substeps", run.substeps},
                                         {"failure", run.failure}});
  return done;
}

}  // namespace meniscus::cli::pbf
